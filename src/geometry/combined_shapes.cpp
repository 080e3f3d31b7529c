#include "mote/geometry/combined_shapes.hpp"

#include <algorithm>

namespace mote {

double Union::distance(const Triple& place) const {
  double nearest = Extent::endless;
  for (const SharedShape& shape : shapes_) nearest = std::min(nearest, shape->distance(place));
  return nearest;
}

bool Union::holds(const Triple& place, double rounding) const {
  return std::ranges::any_of(
      shapes_, [&](const SharedShape& shape) { return shape->holds(place, rounding); });
}

Extent Union::extent() const {
  Extent hull = shapes_.front()->extent();
  for (const SharedShape& shape : shapes_) {
    const Extent extent = shape->extent();
    for (int d = 0; d < 3; ++d) {
      hull.lower[d] = std::min(hull.lower[d], extent.lower[d]);
      hull.upper[d] = std::max(hull.upper[d], extent.upper[d]);
    }
  }
  return hull;
}

double Difference::distance(const Triple& place) const {
  return std::max(whole_->distance(place), -without_->distance(place));
}

bool Difference::holds(const Triple& place, double rounding) const {
  return whole_->holds(place, rounding) && !without_->holds(place, rounding);
}

}  // namespace mote
