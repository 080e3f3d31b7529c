#pragma once

#include "mote/operators/cores/algebraic.hpp"
#include "mote/operators/cores/gauss.hpp"
#include "mote/options/type_list.hpp"

namespace mote {

/// The vortex cores of mote. A new one is its own file and a word here.
using VortexCores = TypeList<GaussCore, AlgebraicCore<2>, AlgebraicCore<4>, AlgebraicCore<6>>;

}  // namespace mote
