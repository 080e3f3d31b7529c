#include "mote/exact/homologous_collapse.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace mote {

using std::numbers::pi;

HomologousCollapse::HomologousCollapse(ColdBall ball)
    : ball_(std::move(ball)),
      rate_(std::sqrt(2 * ball_.gravitational_constant * ball_.mass / std::pow(ball_.radius, 3))) {}

std::string HomologousCollapse::statement() const {
  return fmt::format(
      "cold_collapse is exact for a ball of uniform density, not for bodies one by one, and "
      "without "
      "softening; it ends in a point at t = {:.6g}",
      valid_until());
}

double HomologousCollapse::valid_until() const { return pi / 2 / rate_; }

double HomologousCollapse::beta(double time) const {
  const double scaled = time * rate_;
  if (!(0 <= scaled && scaled <= pi / 2))
    throw std::domain_error("the ball has fallen together by then");
  const auto excess = [scaled](double beta) { return beta + 0.5 * std::sin(2 * beta) - scaled; };
  if (excess(0) >= 0) return 0;
  if (excess(pi / 2) <= 0) return pi / 2;
  const auto close = boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits);
  std::uintmax_t iterations = 200;
  const auto [lower, upper] =
      boost::math::tools::toms748_solve(excess, 0.0, pi / 2, close, iterations);
  return 0.5 * (lower + upper);
}

double HomologousCollapse::contraction(double time) const {
  const double cosine = std::cos(beta(time));
  return cosine * cosine;
}

/// df/dt = -2 cos beta sin beta dbeta/dt with 2 cos^2 beta dbeta/dt = the rate.
double HomologousCollapse::contraction_rate(double time) const {
  return -rate_ * std::tan(beta(time));
}

Table HomologousCollapse::at_places(std::span<const double> position, int dimension,
                                    double time) const {
  const double expansion = contraction_rate(time) / contraction(time);
  return flow_table(position, dimension, WithPressure::no, [&](const auto& place) -> FlowState {
    FlowState state;
    for (std::size_t d = 0; d < 3; ++d) {
      const double centre = ball_.centre[d] + time * ball_.velocity[d];
      state.velocity[d] = ball_.velocity[d] + expansion * (place[d] - centre);
    }
    return state;
  });
}

Table HomologousCollapse::of_particles(double time) const {
  const double size = contraction(time), rate = contraction_rate(time);
  Table table{{"position_x", {}}, {"position_y", {}}, {"position_z", {}},
              {"velocity_x", {}}, {"velocity_y", {}}, {"velocity_z", {}}};
  for (std::size_t k = 0; k < ball_.position.size(); ++k) {
    const std::size_t d = k % 3;
    const double away = ball_.position[k] - ball_.centre[d];
    table[d].values.push_back(ball_.centre[d] + time * ball_.velocity[d] + size * away);
    table[d + 3].values.push_back(ball_.velocity[d] + rate * away);
  }
  return table;
}

}  // namespace mote
