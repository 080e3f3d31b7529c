#include "mote/catalogue/exact_vortices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "mote/catalogue/vortex_start.hpp"
#include "mote/exact/kirchhoff_ellipse.hpp"
#include "mote/exact/lamb_oseen.hpp"
#include "mote/exact/taylor_green.hpp"
#include "mote/exact/vortex_pair.hpp"

namespace mote {
namespace {

using std::numbers::pi;

std::unique_ptr<FlowSolution> pair_from(const FlowSetup& setup) {
  const VortexStart flow(setup, std::string(VortexPair::name));
  flow.need_unbounded_plane();
  flow.need_no_viscosity();
  if (flow.parameter("vortices") != 2 || flow.has_vorticity())
    flow.refuse("needs two entries of 'model.vortices' and no vorticity beside them");
  if (flow.parameter("core_size") > 0) flow.refuse("needs the core 'point'");
  if (flow.parameter("remeshed") != 0) flow.refuse("follows the two vortices: 'remesh' ends them");
  PointVortices vortices;
  for (std::size_t k = 0; k < 2; ++k) {
    vortices.circulation[k] = flow.parameter(fmt::format("circulation_{}", k));
    vortices.place[k] = {flow.parameter(fmt::format("x_{}", k)),
                         flow.parameter(fmt::format("y_{}", k))};
  }
  return std::make_unique<VortexPair>(vortices);
}

/// The vorticity of the blobs with their cores: variances of Gauss functions add up.
std::unique_ptr<FlowSolution> lamb_oseen_from(const FlowSetup& setup) {
  constexpr double same_function = 1e-3;
  const VortexStart flow(setup, std::string(LambOseen::name));
  flow.need_unbounded_plane();
  flow.need_vorticity_alone();
  const VorticityMoments m = flow.moments();
  const double variance = 0.5 * (m.square_x + m.square_y);
  GaussVortex vortex{.circulation = m.circulation,
                     .centre = m.centre,
                     .variance = variance,
                     .viscosity = flow.parameter("viscosity")};
  const auto expected = [&](const Triple& place) {
    const double x = place[0] - m.centre[0], y = place[1] - m.centre[1];
    return m.circulation / (2 * pi * variance) * std::exp(-(x * x + y * y) / (2 * variance));
  };
  const double difference = flow.vorticity_difference(expected);
  if (difference > same_function)
    flow.refuse(
        fmt::format("starts from a Gauss function in a domain that holds nearly all of it, "
                    "and this vorticity differs by {:.2g} of its highest",
                    difference));
  vortex.variance += 0.5 * flow.parameter("core_second_moment");
  return std::make_unique<LambOseen>(vortex);
}

/// The ellipse of the same area and second moments, a^2/4 and b^2/4.
std::unique_ptr<FlowSolution> ellipse_from(const FlowSetup& setup) {
  constexpr double same_ellipse = 0.05;
  const VortexStart flow(setup, std::string(KirchhoffEllipse::name));
  flow.need_unbounded_plane();
  flow.need_no_viscosity();
  flow.need_vorticity_alone();
  const VorticityMoments m = flow.moments();
  const double mean = 0.5 * (m.square_x + m.square_y);
  const double apart = std::hypot(0.5 * (m.square_x - m.square_y), m.product);
  VortexEllipse ellipse{.vorticity = flow.highest(),
                        .long_axis = 2 * std::sqrt(mean + apart),
                        .short_axis = 2 * std::sqrt(mean - apart),
                        .centre = m.centre,
                        .angle = 0.5 * std::atan2(2 * m.product, m.square_x - m.square_y)};
  const double area = pi * ellipse.long_axis * ellipse.short_axis;
  const double held = m.circulation / ellipse.vorticity;
  if (!(std::abs(held / area - 1) < same_ellipse) || !flow.is_uniform())
    flow.refuse("needs one ellipse of uniform vorticity");
  return std::make_unique<KirchhoffEllipse>(ellipse);
}

/// Of sin(k x + a) sin(k y + b) the Fourier coefficient at (k, k) is -exp(i (a + b))/4 and that at
/// (k, -k) is exp(i (a - b))/4.
VortexLattice fitted(const VortexStart& flow, double k) {
  std::complex<double> same, opposite;
  for (const Triple& place : flow.places()) {
    const double vorticity = flow.vorticity(place);
    same += vorticity * std::polar(1.0, -k * (place[0] + place[1]));
    opposite += vorticity * std::polar(1.0, -k * (place[0] - place[1]));
  }
  const double scale = 4 / static_cast<double>(flow.places().size());
  const double sum = std::arg(-same), difference = std::arg(opposite);
  return {.speed = scale * std::abs(same) / (2 * k),
          .wave_number = k,
          .phase_x = 0.5 * (sum + difference),
          .phase_y = 0.5 * (sum - difference)};
}

}  // namespace

bool starts_from_vorticity(const FlowSetup& setup) { return setup.parameters.contains("vortices"); }

std::unique_ptr<FlowSolution> taylor_green_from_vorticity(const FlowSetup& setup) {
  constexpr int most_waves = 8;
  const VortexStart flow(setup, std::string(TaylorGreen::name));
  const SpaceStart& start = flow.space();
  if (!start.periodic[0] || !start.periodic[1])
    flow.refuse("needs a domain that is periodic in x and y");
  flow.need_no_free_stream();
  flow.need_vorticity_alone();
  const double width = start.upper[0] - start.lower[0], height = start.upper[1] - start.lower[1];
  VortexLattice best{.speed = 0};
  for (int n = 1; n <= most_waves; ++n) {
    const double along_y = n * height / width;
    if (std::abs(along_y - std::round(along_y)) > same_start) continue;
    const VortexLattice found = fitted(flow, 2 * pi * n / width);
    if (found.speed > best.speed) best = found;
  }
  if (best.speed == 0) flow.refuse("needs vortices, and there are none that fit the box");
  const double difference = flow.vorticity_difference([&](const Triple& place) {
    const double k = best.wave_number;
    return 2 * best.speed * k * std::sin(k * place[0] + best.phase_x) *
           std::sin(k * place[1] + best.phase_y);
  });
  if (difference > 0.01)
    flow.refuse(
        fmt::format("starts from a vorticity 2 U k sin(k x + a) sin(k y + b) in waves that "
                    "fit the box, and this one differs by {:.2g} of its highest",
                    difference));
  best.viscosity = flow.parameter("viscosity");
  // A core multiplies a wave by its Fourier transform, exp(-k^2 size^2/2) along each axis.
  best.speed *=
      std::exp(-0.5 * best.wave_number * best.wave_number * flow.parameter("core_second_moment"));
  return std::make_unique<TaylorGreen>(best);
}

std::vector<ExactEntry> vortex_entries() {
  return {{choice_of<VortexPair>(), {"position", "velocity"}, {}, pair_from},
          {choice_of<LambOseen>(), {"velocity", "vorticity"}, {}, lamb_oseen_from},
          {choice_of<KirchhoffEllipse>(), {"velocity"}, {}, ellipse_from}};
}

}  // namespace mote
