#pragma once

#include <functional>

#include "mote/geometry/shape.hpp"

namespace mote {

/// The places where a function is positive. Its distance is f / |grad f|, exact to first order near
/// the surface, and infinite where the function has no slope.
class FormulaShape final : public Shape {
 public:
  /// Slopes are differences over `step`.
  FormulaShape(std::function<double(const Triple&)> function, int dimension, double step)
      : function_(std::move(function)), dimension_(dimension), step_(step) {}

  double distance(const Triple& place) const override;
  bool holds(const Triple& place, double rounding) const override;
  Extent extent() const override { return {}; }

 private:
  std::function<double(const Triple&)> function_;
  int dimension_;
  double step_;
};

}  // namespace mote
