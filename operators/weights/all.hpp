#pragma once

#include "mote/operators/weights/reciprocal.hpp"
#include "mote/options/type_list.hpp"

namespace mote {

/// The weights of MPS: singular at the origin, never normalised.
using MpsWeights = TypeList<Reciprocal>;

}  // namespace mote
