#pragma once

#include <cmath>

#include "mote/geometry/shape.hpp"

namespace mote {

/// A ball; in the plane a disc.
class Ball final : public Shape {
 public:
  Ball(const Triple& centre, double radius) : centre_(centre), radius_(radius) {}

  double distance(const Triple& place) const override {
    return std::hypot(place[0] - centre_[0], place[1] - centre_[1], place[2] - centre_[2]) -
           radius_;
  }
  Extent extent() const override {
    Extent extent;
    for (int d = 0; d < 3; ++d) {
      extent.lower[d] = centre_[d] - radius_;
      extent.upper[d] = centre_[d] + radius_;
    }
    return extent;
  }

 private:
  Triple centre_;
  double radius_;
};

}  // namespace mote
