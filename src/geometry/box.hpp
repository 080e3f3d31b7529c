#pragma once

#include "mote/geometry/shape.hpp"

namespace mote {

/// A box with sides along the axes, which may be without an end.
class Box final : public Shape {
 public:
  explicit Box(const Extent& extent) : extent_(extent) {}

  double distance(const Triple& place) const override;
  Extent extent() const override { return extent_; }

 private:
  Extent extent_;
};

}  // namespace mote
