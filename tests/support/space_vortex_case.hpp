#pragma once

#include "support/vortex_case.hpp"

namespace mote::test {

/// Vortices in space as a scenario would give them.
struct SpaceVortexCase : SpaceCase {
  VortexOptions options;
  std::function<Triple(const Place&)> vorticity = [](const Place&) { return Triple{}; };
};

inline std::unique_ptr<Vortex<3>> make_vortices(const SpaceVortexCase& flow) {
  SpaceSetup setup = setup_of<3>(flow);
  setup.initial = [flow](std::string_view field, const Triple& place) {
    return flow.vorticity(place)[static_cast<std::size_t>(field.back() - 'x')];
  };
  setup.compile = [](const std::string&) -> PlaceFunction {
    return [](const Triple&, double) { return 0.25; };
  };
  CorrectedSph<3, WendlandC2<3>> op;
  op.smoothing_length = 1.5;
  setup.differential_operator = std::make_unique<CorrectedSph<3, WendlandC2<3>>>(op);
  return std::make_unique<Vortex<3>>(flow.options, std::move(setup));
}

/// Vorticity of all directions in a box from 0 to 2, with a divergence, in disorder.
inline SpaceVortexCase tangle(double spacing = 0.25) {
  auto flow = fluid_in_a_box<SpaceVortexCase>(3, spacing, {2, 2, 2});
  flow.options.sum = "direct";
  flow.vorticity = [](const Place& p) {
    const double x = p[0] - 1, y = p[1] - 1, z = p[2] - 1;
    const double gauss = 4 * std::exp(-3 * (x * x + 2 * y * y + z * z));
    return Triple{gauss * (0.5 - y), gauss * (x + z), gauss * (1 - x * y)};
  };
  return in_disorder(flow);
}

/// A ring about (0, 0, 0) of radius 1, in the plane across `normal`.
inline SpaceVortexCase one_ring(double spacing = 0.1, double core = 0.25,
                                std::vector<double> normal = {0, 0, 1}) {
  auto flow = fluid_in_a_box<SpaceVortexCase>(3, spacing, {0.5, 0.5, 0.5});
  flow.options.threshold = 1e-2;
  flow.options.rings = {{.centre = {0, 0, 0}, .normal = std::move(normal), .core = core}};
  return flow;
}

}  // namespace mote::test
