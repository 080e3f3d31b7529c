#pragma once

#include <memory>
#include <vector>

#include "mote/geometry/shape.hpp"

namespace mote {

using SharedShape = std::shared_ptr<const Shape>;

/// Everything that is in one of several shapes. Where they overlap, the distance is from the
/// surface of the one that a place is deepest in, and may be too small.
class Union final : public Shape {
 public:
  explicit Union(std::vector<SharedShape> shapes) : shapes_(std::move(shapes)) {}

  double distance(const Triple& place) const override;
  bool holds(const Triple& place, double rounding) const override;
  Extent extent() const override;

 private:
  std::vector<SharedShape> shapes_;
};

/// A shape without another.
class Difference final : public Shape {
 public:
  Difference(SharedShape whole, SharedShape without)
      : whole_(std::move(whole)), without_(std::move(without)) {}

  double distance(const Triple& place) const override;
  /// A place on the surface of what is left out stays: the two share no place and leave none out.
  bool holds(const Triple& place, double rounding) const override;
  Extent extent() const override { return whole_->extent(); }

 private:
  SharedShape whole_, without_;
};

}  // namespace mote
