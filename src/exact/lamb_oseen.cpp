#include "mote/exact/lamb_oseen.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace mote {
namespace {

using std::numbers::pi;

/// (1 - exp(-x))/x, finite at 0.
double decaying_share(double x) { return x == 0 ? 1 : -std::expm1(-x) / x; }

}  // namespace

std::string LambOseen::statement() const {
  return fmt::format(
      "lamb_oseen is exact for a vortex of circulation {:.6g}, of variance {:.6g} at the start, "
      "and "
      "viscosity {:.6g} in an unbounded plane",
      vortex_.circulation, vortex_.variance, vortex_.viscosity);
}

Table LambOseen::at_places(std::span<const double> position, int dimension, double time) const {
  const double variance = this->variance(time);
  const double peak = vortex_.circulation / (2 * pi * variance);
  Column vorticity{"vorticity", {}};
  Table table =
      flow_table(position, dimension, WithPressure::no, [&](const auto& place) -> FlowState {
        const double x = place[0] - vortex_.centre[0], y = place[1] - vortex_.centre[1];
        const double exponent = (x * x + y * y) / (2 * variance);
        vorticity.values.push_back(peak * std::exp(-exponent));
        const double turning = 0.5 * peak * decaying_share(exponent);
        return {{-turning * y, turning * x}};
      });
  table.push_back(std::move(vorticity));
  return table;
}

}  // namespace mote
