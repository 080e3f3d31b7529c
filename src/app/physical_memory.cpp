#include "mote/app/physical_memory.hpp"

#include <unistd.h>

namespace mote {

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace mote
