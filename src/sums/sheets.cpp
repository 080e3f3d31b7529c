#include "mote/sums/sheets.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace mote {

using std::numbers::pi;

void sheet_acceleration(std::span<const double> mass, double gravity,
                        std::span<double> acceleration) {
  const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
  double below = 0;
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const double above = total - below - mass[i];
    acceleration[i] = 2 * pi * gravity * (above - below);
    below += mass[i];
  }
}

void sheet_potential(std::span<const double> position, std::span<const double> mass, double gravity,
                     std::span<const double> place, std::span<double> mass_below,
                     std::span<double> moment_below, std::span<double> potential) {
  const std::size_t count = mass.size();
  const double origin = position[0];  // far from 0 the moments would lose digits
  mass_below[0] = moment_below[0] = 0;
  for (std::size_t j = 0; j < count; ++j) {
    mass_below[j + 1] = mass_below[j] + mass[j];
    moment_below[j + 1] = moment_below[j] + mass[j] * (position[j] - origin);
  }
  for (std::size_t k = 0; k < place.size(); ++k) {
    const auto below = std::ranges::lower_bound(position, place[k]) - position.begin();
    const double mass_excess = 2 * mass_below[below] - mass_below[count];
    const double moment_excess = 2 * moment_below[below] - moment_below[count];
    potential[k] = 2 * pi * gravity * ((place[k] - origin) * mass_excess - moment_excess);
  }
}

double sheet_energy(std::span<const double> position, std::span<const double> mass,
                    double gravity) {
  double energy = 0, mass_below = 0, moment_below = 0;
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const double x = position[i] - position[0];
    energy += 2 * pi * gravity * mass[i] * (x * mass_below - moment_below);
    mass_below += mass[i];
    moment_below += mass[i] * x;
  }
  return energy;
}

}  // namespace mote
