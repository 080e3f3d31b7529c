#pragma once

#include <string>

#include "mote/integrators/system.hpp"

namespace mote {

/// What a system lacks for methods whose accelerations follow from time and places: empty, or this
/// in words, for `Integrator::missing_in`.
inline std::string missing_for_free_fall(const System& system) {
  return system.falls_freely() ? "" : "accelerations that depend on time and places alone";
}

}  // namespace mote
