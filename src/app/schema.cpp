#include "mote/scenario/schema.hpp"

#include <fmt/format.h>

#include "mote/app/commands.hpp"
#include "mote/stationary/stationary_file.hpp"
#include "mote/study/study_file.hpp"

namespace mote {

int print_schema(const Catalogue& catalogue, const std::string& of) {
  fmt::print("{}\n", of == "study"        ? study_schema(catalogue)
                     : of == "stationary" ? stationary_schema()
                                          : scenario_schema(catalogue));
  return 0;
}

}  // namespace mote
