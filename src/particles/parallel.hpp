#pragma once

#include "mote/particles/vector.hpp"

namespace mote {

/// Loops over fewer particles than this run on one thread: waking the others costs more. Results
/// do not depend on it.
inline constexpr Index parallel_from = 4000;

}  // namespace mote
