#include "mote/geometry/formula_shape.hpp"

#include <cmath>

namespace mote {

double FormulaShape::distance(const Triple& place) const {
  Triple slope{};
  for (int d = 0; d < dimension_; ++d) {
    Triple before = place, behind = place;
    before[d] -= step_;
    behind[d] += step_;
    slope[d] = (function_(behind) - function_(before)) / (2 * step_);
  }
  const double value = function_(place);
  return value == 0 ? 0 : -value / std::hypot(slope[0], slope[1], slope[2]);
}

bool FormulaShape::holds(const Triple& place, double) const { return function_(place) > 0; }

}  // namespace mote
