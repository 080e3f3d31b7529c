#pragma once

#include <string_view>

#include "mote/exact/channel.hpp"
#include "mote/exact/flow_solution.hpp"

namespace mote {

/// Speed of a fluid at rest between walls at y = 0 and y = width, pushed along them by a unit force
/// per mass from t = 0 on: u_t = nu u_yy + 1, u = 0 at the walls. In T = nu t/width^2, lengths in
/// widths and speeds in width^2/nu it is, by separation,
///   u = y (1 - y)/2 - sum over odd n of 4/(n pi)^3 sin(n pi y) exp(-n^2 pi^2 T),
/// and by the inverse of the Laplace transform term by term (Carslaw and Jaeger 1959, chapter 12)
///   u = T (1 - sum_m (-1)^m (G((m + y)/(2 sqrt T)) + G((m + 1 - y)/(2 sqrt T)))),
///   G(z) = (1 + 2 z^2) erfc z - 2 z exp(-z^2)/sqrt(pi).
/// The second converges at early times, the first at late ones: together to rounding for t >= 0.
double poiseuille_start(double y, double time, double width, double viscosity);

/// Flow between two walls at rest, pushed along them from rest.
class PoiseuilleStart final : public FlowSolution {
 public:
  static constexpr std::string_view name = "poiseuille_start";
  static constexpr std::string_view summary =
      "a fluid at rest between two walls, pushed along them by a constant force";

  /// `force` is per mass and along the walls; the viscosity is kinematic and positive.
  PoiseuilleStart(const Channel& channel, const std::array<double, 3>& force, double viscosity)
      : channel_(channel), force_(force), viscosity_(viscosity) {}

  std::string statement() const override;
  Table at_places(std::span<const double> position, int dimension, double time) const override;

 private:
  Channel channel_;
  std::array<double, 3> force_;
  double viscosity_;
};

}  // namespace mote
