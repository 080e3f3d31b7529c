#include "mote/geometry/shape.hpp"

#include <cmath>

namespace mote {
namespace {

Triple slope(const Shape& shape, const Triple& place, int dimension, double step) {
  Triple slope{};
  for (int d = 0; d < dimension; ++d) {
    Triple before = place, behind = place;
    before[d] -= step;
    behind[d] += step;
    slope[d] = (shape.distance(behind) - shape.distance(before)) / (2 * step);
  }
  return slope;
}

double length(const Triple& vector) { return std::hypot(vector[0], vector[1], vector[2]); }

}  // namespace

Triple outward_direction(const Shape& shape, const Triple& place, int dimension, double step) {
  constexpr double least = 0.1;            // the slope of a distance is 1
  constexpr double aside[] = {4, 2, 1.5};  // along no axis and no diagonal
  Triple direction = slope(shape, place, dimension, step);
  if (!(length(direction) > least)) {
    Triple beside = place;
    for (int d = 0; d < dimension; ++d) beside[d] += aside[d] * step;
    direction = slope(shape, beside, dimension, step);
  }
  const double size = length(direction);
  for (double& component : direction) component = size > 0 ? component / size : 0;
  return direction;
}

}  // namespace mote
