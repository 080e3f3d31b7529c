#include "mote/scenario/schema.hpp"

#include <fmt/format.h>

#include "mote/app/commands.hpp"

namespace mote {

int print_schema(const Catalogue& catalogue) {
  fmt::print("{}\n", scenario_schema(catalogue));
  return 0;
}

}  // namespace mote
