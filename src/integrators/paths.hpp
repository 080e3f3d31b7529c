#pragma once

#include "mote/integrators/hermite_path.hpp"
#include "mote/options/type_list.hpp"

namespace mote {

/// The paths between steps of any method. A new one is its own file and a word here.
using Paths = TypeList<CubicHermite, QuinticHermite, TwoStepHermite, ThreeStepHermite>;

}  // namespace mote
