#include <cmath>
#include <numbers>

#include "mote/catalogue/exact_flows.hpp"
#include "mote/catalogue/flow_start.hpp"
#include "mote/exact/hydrostatic.hpp"
#include "mote/exact/standing_wave.hpp"

namespace mote {
namespace {

/// How well a wave of amplitude 1 explains a start: share of the velocities, share of the surface.
struct Explained {
  double rise, elevation;
};

/// Least squares: velocities of the fluid against those of a wave that rises at the rate 1; and the
/// surface through integral over the water of cos(k x + a) = width E/2.
Explained explained(const FlowStart& flow, WaveTank tank, double width) {
  tank.rise = 1;
  const StandingWave wave(tank);
  double product = 0, square = 0, cosines = 0;
  for (const Triple& place : flow.fluid()) {
    const double position[] = {place[0], place[1]};
    const Table unit = wave.at_places(position, 2, 0);
    const Triple velocity = flow.velocity(place);
    for (std::size_t d = 0; d < 2; ++d) {
      product += velocity[d] * unit[d].values[0];
      square += unit[d].values[0] * unit[d].values[0];
    }
    cosines += std::cos(tank.wave_number * place[0] + tank.phase);
  }
  const double cell = flow.space().spacing * flow.space().spacing;
  return {product / square, 2 * cell * cosines / width};
}

WaveTank still_tank(const FlowStart& flow, double width) {
  const Triple gravity = flow.gravity();
  if (gravity[0] != 0 || gravity[1] >= 0) flow.refuse("needs gravity downwards, along -y");
  const double cell = flow.space().spacing * flow.space().spacing;
  return {.density = flow.parameter("density"),
          .gravity = -gravity[1],
          .viscosity = flow.parameter("viscosity"),
          .bottom = flow.lowest(1),
          .depth = static_cast<double>(flow.fluid().size()) * cell / width};
}

}  // namespace

std::unique_ptr<FlowSolution> hydrostatic_from(const FlowSetup& setup) {
  const FlowStart flow(setup, std::string(Hydrostatic::name));
  flow.need_rest();
  const Triple gravity = flow.gravity();
  std::size_t axis = 0;
  int axes = 0;
  for (std::size_t d = 0; d < 3; ++d)
    if (gravity[d] != 0) {
      axis = d;
      ++axes;
    }
  if (axes != 1) flow.refuse("needs gravity along one axis");
  if (flow.space().periodic[axis]) flow.refuse("needs a bottom, and the domain is periodic");
  Triple surface{};
  surface[axis] = gravity[axis] < 0 ? flow.highest(axis) : flow.lowest(axis);
  return std::make_unique<Hydrostatic>(flow.parameter("density"), gravity, surface);
}

std::unique_ptr<FlowSolution> standing_wave_from(const FlowSetup& setup) {
  constexpr int most_waves = 8;
  const FlowStart flow(setup, std::string(StandingWave::name));
  flow.need_dimension(2);
  const double left = flow.lowest(0), width = flow.highest(0) - left;
  WaveTank best = still_tank(flow, width);
  double best_energy = 0;
  for (int n = flow.space().periodic[0] ? 2 : 1; n <= most_waves;
       n += flow.space().periodic[0] ? 2 : 1) {
    WaveTank tank = best;
    tank.wave_number = n * std::numbers::pi / width;
    tank.phase = -tank.wave_number * left;
    const auto [rise, elevation] = explained(flow, tank, width);
    const double frequency = StandingWave(tank).frequency();
    const double energy = rise * rise + frequency * frequency * elevation * elevation;
    if (energy <= best_energy) continue;
    best_energy = energy;
    best = tank;
    best.rise = rise;
    best.elevation = elevation;
  }
  if (best_energy <= same_start * same_start * best.gravity * best.depth)
    flow.refuse("needs a wave, this water is level and at rest");
  auto solution = std::make_unique<StandingWave>(best);
  flow.need_velocities_of(
      *solution, flow.fluid(),
      "starts from rest or with the velocities of one wave of linear theory with a crest at the "
      "left end, and these differ by {:.2g} of the largest");
  return solution;
}

}  // namespace mote
