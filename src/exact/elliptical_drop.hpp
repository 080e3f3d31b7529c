#pragma once

#include <string_view>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// An ellipse of fluid at the start, with the velocity u = A (x - x0), v = -A (y - y0).
struct StretchedDrop {
  double semi_axis_x = 1, semi_axis_y = 1;  ///< a and b [length]
  double rate = 1;                          ///< A [1/time]; negative: it stretches along y
  double density = 1;
  std::array<double, 2> centre{};
};

/// A drop in a plane without viscosity, gravity or surface tension, which stretches and stays an
/// ellipse with a velocity linear in place: a' = A a, b' = -A b. Euler's equations with
///   p = rho P/2 (1 - (x/a)^2 - (y/b)^2),   A' + A^2 = P/a^2,   -A' + A^2 = P/b^2
/// give, added and subtracted,
///   P = 2 A^2 a^2 b^2/(a^2 + b^2),   A' = A^2 (b^2 - a^2)/(a^2 + b^2),
/// so A^2 (a^2 + b^2), the energy, stays. With a = c e^s, b = c/e^s this is one equation,
///   s' = A = A0 sqrt(cosh 2 s0/cosh 2 s).
/// The problem is that of Monaghan (1994), J. Comput. Phys. 110, 399.
class EllipticalDrop final : public FlowSolution {
 public:
  static constexpr std::string_view name = "elliptical_drop";
  static constexpr std::string_view summary =
      "a drop without viscosity that stretches to an ellipse, in two dimensions";

  struct Shape {
    double semi_axis_x, semi_axis_y, rate;  ///< a, b and A
  };

  explicit EllipticalDrop(const StretchedDrop& start) : start_(start) {}

  /// By Runge-Kutta steps of 1/2000 of the time 1/A0, which is to rounding.
  Shape shape(double time) const;
  std::string statement() const override;
  Table at_places(std::span<const double> position, int dimension, double time) const override;

 private:
  StretchedDrop start_;
};

}  // namespace mote
