#include "mote/exact/standing_wave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mote {
namespace {

/// cosh(k z)/sinh(k H) and sinh(k z)/sinh(k H), also where each alone would overflow.
double even_profile(double kz, double kH) {
  return (std::exp(kz - kH) + std::exp(-kz - kH)) / -std::expm1(-2 * kH);
}
double odd_profile(double kz, double kH) {
  return (std::exp(kz - kH) - std::exp(-kz - kH)) / -std::expm1(-2 * kH);
}

}  // namespace

StandingWave::StandingWave(const WaveTank& tank)
    : tank_(tank),
      frequency_(
          std::sqrt(tank.gravity * tank.wave_number * std::tanh(tank.wave_number * tank.depth))) {}

std::string StandingWave::statement() const {
  const double height = std::hypot(tank_.elevation, tank_.rise / frequency_);
  return fmt::format(
      "standing_wave is linear theory, period {:.6g}: it leaves out what is of second order in the "
      "steepness, here {:.3g}, and layers at walls that hold the fluid",
      2 * std::acos(-1.0) / frequency_, height * tank_.wave_number);
}

double StandingWave::height(double time) const {
  const double decay =
      std::exp(-2 * tank_.viscosity * tank_.wave_number * tank_.wave_number * time);
  const double phase = frequency_ * time;
  return decay * (tank_.elevation * std::cos(phase) + tank_.rise / frequency_ * std::sin(phase));
}

double StandingWave::rise(double time) const {
  const double decay =
      std::exp(-2 * tank_.viscosity * tank_.wave_number * tank_.wave_number * time);
  const double phase = frequency_ * time;
  return decay * (tank_.rise * std::cos(phase) - tank_.elevation * frequency_ * std::sin(phase));
}

double StandingWave::elevation(double x, double time) const {
  return height(time) * std::cos(tank_.wave_number * x + tank_.phase);
}

FlowState StandingWave::at(double x, double z, int last_axis, double time) const {
  const double k = tank_.wave_number, above_bottom = z - tank_.bottom;
  const double even = even_profile(k * above_bottom, k * tank_.depth);
  const double odd = odd_profile(k * above_bottom, k * tank_.depth);
  const double cosine = std::cos(k * x + tank_.phase), sine = std::sin(k * x + tank_.phase);
  FlowState state;
  state.velocity[0] = -rise(time) * even * sine;
  state.velocity[static_cast<std::size_t>(last_axis)] = rise(time) * odd * cosine;
  // phi_t has E'' = -omega^2 E.
  const double potential_rate = -frequency_ * frequency_ * height(time) * even / k * cosine;
  state.pressure = tank_.density * (tank_.gravity * (tank_.depth - above_bottom) - potential_rate);
  return state;
}

Table StandingWave::at_places(std::span<const double> position, int dimension, double time) const {
  const int last = dimension - 1;
  return flow_table(position, dimension, WithPressure::yes, [&](const auto& place) {
    return at(place[0], place[static_cast<std::size_t>(last)], last, time);
  });
}

}  // namespace mote
