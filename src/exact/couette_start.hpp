#pragma once

#include <string_view>

#include "mote/exact/channel.hpp"
#include "mote/exact/flow_solution.hpp"

namespace mote {

/// Speed of a fluid at rest above a wall at y = 0, when the wall at y = width moves with the speed
/// 1 from t = 0 on: u_t = nu u_yy. In T = nu t/width^2 and widths it is, by separation,
///   u = y + sum over n of 2 (-1)^n/(n pi) sin(n pi y) exp(-n^2 pi^2 T),
/// and by images, for early times (Carslaw and Jaeger 1959, chapter 12),
///   u = sum_m erfc((2 m + 1 - y)/(2 sqrt T)) - erfc((2 m + 1 + y)/(2 sqrt T)).
double couette_start(double y, double time, double width, double viscosity);

/// Flow between two walls which move along themselves with constant velocities from t = 0 on; the
/// equations are linear, so each wall adds its own flow.
class CouetteStart final : public FlowSolution {
 public:
  static constexpr std::string_view name = "couette_start";
  static constexpr std::string_view summary =
      "a fluid at rest between two walls, of which one or both start to move along themselves";

  struct Walls {
    std::array<double, 3> lower{}, upper{};  ///< velocities
  };

  CouetteStart(const Channel& channel, const Walls& walls, double viscosity)
      : channel_(channel), walls_(walls), viscosity_(viscosity) {}

  std::string statement() const override;
  Table at_places(std::span<const double> position, int dimension, double time) const override;

 private:
  Channel channel_;
  Walls walls_;
  double viscosity_;
};

}  // namespace mote
