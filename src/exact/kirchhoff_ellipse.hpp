#pragma once

#include <array>
#include <string_view>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// An ellipse of uniform vorticity in fluid without any.
struct VortexEllipse {
  double vorticity = 1;
  double long_axis = 2, short_axis = 1;  ///< halves a >= b
  std::array<double, 2> centre{};
  double angle = 0;  ///< of the long axis to x at the start
};

/// Kirchhoff (1876): the ellipse keeps its shape and turns at the rate omega a b/(a + b)^2. Along
/// its axes, with z = x + i y and c^2 = a^2 - b^2,
///   inside:  u = -omega a/(a + b) y,   v = omega b/(a + b) x,
///   outside: u - i v = -i omega a b/(z + sqrt(z^2 - c^2)).
class KirchhoffEllipse final : public FlowSolution {
 public:
  static constexpr std::string_view name = "kirchhoff_ellipse";
  static constexpr std::string_view summary = "a turning ellipse of uniform vorticity";

  explicit KirchhoffEllipse(const VortexEllipse& ellipse) : ellipse_(ellipse) {}

  std::string statement() const override;
  /// The velocity.
  Table at_places(std::span<const double> position, int dimension, double time) const override;

  double turning_rate() const;  ///< [radian/time]

 private:
  VortexEllipse ellipse_;
};

}  // namespace mote
