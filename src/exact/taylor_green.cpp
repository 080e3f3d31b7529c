#include "mote/exact/taylor_green.hpp"

#include <fmt/format.h>

#include <cmath>

namespace mote {

std::string TaylorGreen::statement() const {
  return fmt::format(
      "taylor_green is exact for incompressible flow of speed {:.6g}, wave number {:.6g} and "
      "viscosity {:.6g}; a gas of finite sound speed differs by the square of its Mach number",
      lattice_.speed, lattice_.wave_number, lattice_.viscosity);
}

FlowState TaylorGreen::at(const std::array<double, 3>& place, double time) const {
  const double k = lattice_.wave_number;
  const double decay = std::exp(-2 * lattice_.viscosity * k * k * time);
  const double x = k * place[0] + lattice_.phase_x, y = k * place[1] + lattice_.phase_y;
  const double speed = lattice_.speed * decay;
  return {{speed * std::sin(x) * std::cos(y), -speed * std::cos(x) * std::sin(y)},
          lattice_.mean_pressure +
              lattice_.density * speed * speed / 4 * (std::cos(2 * x) + std::cos(2 * y))};
}

Table TaylorGreen::at_places(std::span<const double> position, int dimension, double time) const {
  return flow_table(position, dimension, WithPressure::yes,
                    [&](const auto& place) { return at(place, time); });
}

}  // namespace mote
