#include "mote/catalogue/exact_flows.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "mote/catalogue/exact_vortices.hpp"
#include "mote/catalogue/flow_start.hpp"
#include "mote/exact/couette_start.hpp"
#include "mote/exact/elliptical_drop.hpp"
#include "mote/exact/hydrostatic.hpp"
#include "mote/exact/poiseuille_start.hpp"
#include "mote/exact/standing_wave.hpp"
#include "mote/exact/taylor_green.hpp"

namespace mote {
namespace {

/// Places on a lattice in the box, enough to tell `most_waves` waves across it apart.
constexpr int most_waves = 8;
std::vector<Triple> sample_places(const SpaceStart& start) {
  constexpr int samples = 4 * most_waves + 1;
  std::vector<Triple> places;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j)
      places.push_back({start.lower[0] + (start.upper[0] - start.lower[0]) * (i + 0.5) / samples,
                        start.lower[1] + (start.upper[1] - start.lower[1]) * (j + 0.5) / samples});
  return places;
}

/// U, a and b of the lattice with this wave number: U sin(k x + a) cos(k y + b) has the Fourier
/// coefficients U exp(i (a + b))/(4 i) at (k, k) and U exp(i (a - b))/(4 i) at (k, -k).
VortexLattice fitted(const FlowStart& flow, const std::vector<Triple>& places, double k) {
  std::complex<double> same, opposite;
  for (const Triple& place : places) {
    const double u = flow.initial("velocity_x", place);
    same += u * std::polar(1.0, -k * (place[0] + place[1]));
    opposite += u * std::polar(1.0, -k * (place[0] - place[1]));
  }
  const std::complex<double> scale{0, 4.0 / static_cast<double>(places.size())};
  const double sum = std::arg(scale * same), difference = std::arg(scale * opposite);
  return {.speed = std::abs(scale * same),
          .wave_number = k,
          .phase_x = 0.5 * (sum + difference),
          .phase_y = 0.5 * (sum - difference)};
}

/// The strongest of the lattices that fit into the box.
VortexLattice strongest(const FlowStart& flow, const std::vector<Triple>& places) {
  const SpaceStart& start = flow.space();
  const double width = start.upper[0] - start.lower[0], height = start.upper[1] - start.lower[1];
  VortexLattice best{.speed = 0};
  for (int n = 1; n <= most_waves; ++n) {
    const double along_y = n * height / width;
    if (std::abs(along_y - std::round(along_y)) > same_start || along_y > most_waves) continue;
    const VortexLattice found = fitted(flow, places, 2 * std::numbers::pi * n / width);
    if (found.speed > best.speed) best = found;
  }
  return best;
}

/// u = A (x - x0), v = -A (y - y0) by least squares, and the ellipse that has the second moments of
/// the cells: those of an ellipse are a^2/4 and b^2/4, a cell adds its own spacing^2/12.
StretchedDrop fitted_drop(const FlowStart& flow) {
  const auto count = static_cast<double>(flow.fluid().size());
  std::array<double, 2> centre{}, mean{}, square{};
  for (const Triple& place : flow.fluid())
    for (std::size_t d = 0; d < 2; ++d) {
      centre[d] += place[d] / count;
      mean[d] += flow.velocity(place)[d] / count;
    }
  double stretch = 0;
  for (const Triple& place : flow.fluid()) {
    const double x = place[0] - centre[0], y = place[1] - centre[1];
    const Triple velocity = flow.velocity(place);
    stretch += velocity[0] * x - velocity[1] * y;
    square[0] += x * x;
    square[1] += y * y;
  }
  StretchedDrop drop{.rate = stretch / (square[0] + square[1])};
  const double cell = flow.space().spacing * flow.space().spacing / 12;
  drop.semi_axis_x = 2 * std::sqrt(square[0] / count + cell);
  drop.semi_axis_y = 2 * std::sqrt(square[1] / count + cell);
  if (drop.rate != 0)
    drop.centre = {centre[0] - mean[0] / drop.rate, centre[1] + mean[1] / drop.rate};
  return drop;
}

}  // namespace

std::unique_ptr<FlowSolution> taylor_green_from(const FlowSetup& setup) {
  if (starts_from_vorticity(setup)) return taylor_green_from_vorticity(setup);
  const FlowStart flow(setup, std::string(TaylorGreen::name));
  flow.need_dimension(2);
  flow.need_no_gravity();
  if (!flow.space().periodic[0] || !flow.space().periodic[1])
    flow.refuse("needs a domain that is periodic in x and y");
  const std::vector<Triple> places = sample_places(flow.space());
  VortexLattice lattice = strongest(flow, places);
  if (lattice.speed == 0) flow.refuse("needs vortices, and this fluid has none that fit the box");
  lattice.density = flow.parameter("density");
  lattice.viscosity = flow.parameter("viscosity");
  for (const Triple& place : places)
    lattice.mean_pressure += flow.initial("pressure", place) / static_cast<double>(places.size());
  auto solution = std::make_unique<TaylorGreen>(lattice);
  flow.need_velocities_of(
      *solution, places,
      "starts with u = U sin(k x + a) cos(k y + b), v = -U cos(k x + a) sin(k y + b) in waves that "
      "fit the box, and this start differs by {:.2g} of U");
  return solution;
}

std::unique_ptr<FlowSolution> drop_from(const FlowSetup& setup) {
  const FlowStart flow(setup, std::string(EllipticalDrop::name));
  flow.need_dimension(2);
  flow.need_no_gravity();
  if (flow.parameter("viscosity") != 0) flow.refuse("has no viscosity, this fluid has");
  if (!flow.space().wall_places.empty()) flow.refuse("is free all around, and here are walls");
  StretchedDrop drop = fitted_drop(flow);
  if (drop.rate == 0) flow.refuse("needs a drop that stretches, and this one is at rest");
  drop.density = flow.parameter("density");
  auto solution = std::make_unique<EllipticalDrop>(drop);
  flow.need_velocities_of(*solution, flow.fluid(),
                          "starts with u = A (x - x0), v = -A (y - y0), and this start differs by "
                          "{:.2g} of the largest velocity");
  return solution;
}

std::vector<ExactEntry> flow_entries() {
  const std::vector<std::string> velocity{"velocity"}, both{"velocity", "pressure"};
  return {{choice_of<TaylorGreen>(), both, {}, taylor_green_from},
          {choice_of<PoiseuilleStart>(), velocity, {}, poiseuille_from},
          {choice_of<CouetteStart>(), velocity, {}, couette_from},
          {choice_of<Hydrostatic>(), both, {}, hydrostatic_from},
          {choice_of<StandingWave>(), both, {}, standing_wave_from},
          {choice_of<EllipticalDrop>(), both, {}, drop_from}};
}

}  // namespace mote
