#include "mote/exact/vortex_pair.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace mote {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// u + i v of a vortex at a distance; on the very place of the vortex none.
Complex velocity_of(double circulation, Complex distance) {
  if (distance == Complex(0)) return 0;
  return Complex(0, circulation / (2 * pi)) / std::conj(distance);
}

}  // namespace

VortexPair::VortexPair(const PointVortices& vortices) : start_(vortices) {
  const double squared = std::norm(vortices.place[1] - vortices.place[0]);
  rate_ = (vortices.circulation[0] + vortices.circulation[1]) / (2 * pi * squared);
}

std::string VortexPair::statement() const {
  return fmt::format(
      "vortex_pair is exact for two point vortices without friction in an unbounded plane, which "
      "turn at the rate {:.6g}",
      rate_);
}

/// Both go with the velocities of the start, turned by the angle rate t: the way that this makes is
/// velocity (exp(i rate t) - 1)/(i rate), which for opposite vortices is velocity t.
std::array<Complex, 2> VortexPair::places(double time) const {
  const Complex apart = start_.place[0] - start_.place[1];
  const double half = 0.5 * rate_ * time;
  const double sine = half == 0 ? 1 : std::sin(half) / half;
  const Complex way = time * sine * std::polar(1.0, half);
  return {start_.place[0] + way * velocity_of(start_.circulation[1], apart),
          start_.place[1] + way * velocity_of(start_.circulation[0], -apart)};
}

Table VortexPair::of_particles(double time) const {
  const auto place = places(time);
  Table table{{"position_x", {}}, {"position_y", {}}, {"velocity_x", {}}, {"velocity_y", {}}};
  for (std::size_t k = 0; k < 2; ++k) {
    const Complex velocity = velocity_of(start_.circulation[1 - k], place[k] - place[1 - k]);
    const double row[] = {place[k].real(), place[k].imag(), velocity.real(), velocity.imag()};
    for (std::size_t c = 0; c < table.size(); ++c) table[c].values.push_back(row[c]);
  }
  return table;
}

Table VortexPair::at_places(std::span<const double> position, int dimension, double time) const {
  const auto place = places(time);
  return flow_table(position, dimension, WithPressure::no, [&](const auto& there) -> FlowState {
    Complex velocity;
    for (std::size_t k = 0; k < 2; ++k)
      velocity += velocity_of(start_.circulation[k], Complex(there[0], there[1]) - place[k]);
    return {{velocity.real(), velocity.imag()}};
  });
}

}  // namespace mote
