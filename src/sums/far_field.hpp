#pragma once

#include "mote/sums/pair_kernel.hpp"

namespace mote {

/// What a pair kernel looks like from afar; specialised for every kernel that the multipole method
/// sums:
///   FarField(expansion, taylor, radius)   a Taylor series about the centre of a node
///   add(offset, sums)                     adds its values at eight places, `offset` from there
template <PairKernel K>
class FarField;

/// Outputs of a kernel that are derivatives of the potential of one order.
struct FieldPart {
  int first, count;
  int derivatives;
};

}  // namespace mote
