#pragma once

#include <string>
#include <vector>

#include "mote/geometry/shape.hpp"

namespace mote {

/// What keeps these corners, in order, from being a polygon; empty if nothing does.
std::string polygon_problem(const std::vector<double>& x, const std::vector<double>& y);

/// A polygon in the plane of x and y; in space a prism over it from `bottom` to `top` along z.
class Polygon final : public Shape {
 public:
  /// The corners in order, either way round; the last is joined to the first.
  Polygon(std::vector<double> x, std::vector<double> y, double bottom = -Extent::endless,
          double top = Extent::endless)
      : x_(std::move(x)), y_(std::move(y)), bottom_(bottom), top_(top) {}

  double distance(const Triple& place) const override;
  Extent extent() const override;

 private:
  double distance_in_the_plane(double x, double y) const;

  std::vector<double> x_, y_;
  double bottom_, top_;
};

}  // namespace mote
