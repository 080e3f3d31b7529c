#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "mote/integrators/runge_kutta_4.hpp"
#include "mote/models/vortex.hpp"
#include "mote/operators/differential/corrected_sph.hpp"
#include "support/space_case.hpp"

namespace mote::test {

/// Vortices as a scenario would give them.
struct VortexCase : SpaceCase {
  VortexOptions options;
  std::function<double(const Place&)> vorticity = [](const Place&) { return 0.0; };
};

/// Blobs of this vorticity in a box from -1 to 1, in disorder.
inline VortexCase blobs_of(std::function<double(const Place&)> vorticity, double spacing = 0.1) {
  auto flow = fluid_in_a_box<VortexCase>(2, spacing, {2, 2, 0});
  flow.vorticity = std::move(vorticity);
  return in_disorder(flow);
}

/// A round vortex beside a weaker one of the other sign, in a box from 0 to 2.
inline double two_vortices(const Place& place) {
  const auto gauss = [&](double x, double y) {
    return std::exp(-12 * (std::pow(place[0] - x, 2) + std::pow(place[1] - y, 2)));
  };
  return 3 * gauss(0.8, 1.1) - gauss(1.3, 0.9);
}

inline std::unique_ptr<Vortex<2>> make_vortices(const VortexCase& flow) {
  SpaceSetup setup = setup_of<2>(flow);
  setup.initial = [flow](std::string_view, const Triple& place) { return flow.vorticity(place); };
  setup.compile = [](const std::string&) -> PlaceFunction {
    return [](const Triple&, double) { return 0.25; };
  };
  CorrectedSph<2, WendlandC2<2>> op;
  op.smoothing_length = 1.5;
  setup.differential_operator = std::make_unique<CorrectedSph<2, WendlandC2<2>>>(op);
  return std::make_unique<Vortex<2>>(flow.options, std::move(setup));
}

/// Steps of this length, as a run takes them.
template <int D>
void take_steps(Vortex<D>& flow, int steps, double step, double start = 0) {
  RungeKutta4 integrator;
  flow.start_afresh();
  for (int k = 0; k < steps; ++k) {
    const double time = start + k * step;
    flow.begin_step(time, step);
    integrator.advance_one_step(flow, time, step);
    flow.end_step(time, step);
    flow.update_dependent_fields();
  }
}

/// Largest drift of what is conserved, relative to its scale.
inline double largest_drift(const std::vector<Conserved>& start,
                            const std::vector<Conserved>& end) {
  double largest = 0;
  for (std::size_t k = 0; k < start.size(); ++k)
    largest = std::max(largest, std::abs(end[k].value - start[k].value) / start[k].scale);
  return largest;
}

}  // namespace mote::test
