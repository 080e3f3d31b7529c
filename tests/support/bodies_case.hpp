#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "mote/integrators/integrator.hpp"
#include "mote/models/bodies.hpp"
#include "support/space_case.hpp"

namespace mote::test {

template <int D>
std::unique_ptr<Bodies<D>> make_bodies(const BodiesOptions& options) {
  SpaceSetup setup;
  setup.dimension = D;
  return std::make_unique<Bodies<D>>(options, std::move(setup));
}

inline Cluster plummer(std::int64_t count, std::int64_t seed = 0) {
  return {.type = "plummer", .count = count, .seed = seed};
}
inline Cluster uniform_ball(std::int64_t count, std::int64_t seed = 0) {
  return {.type = "uniform_ball", .count = count, .seed = seed};
}

/// Steps of this length, as a run takes them.
template <class Method>
void take_steps(Model& model, Method integrator, int steps, double step) {
  for (int k = 0; k < steps; ++k) {
    model.begin_step(k * step, step);
    integrator.advance_one_step(model, k * step, step);
    model.end_step(k * step, step);
    model.update_dependent_fields();
  }
}

/// Drift of a conserved quantity between two states, over its scale.
inline double drift_of(const std::string& name, const std::vector<Conserved>& start,
                       const std::vector<Conserved>& end) {
  for (std::size_t k = 0; k < start.size(); ++k)
    if (start[k].name == name)
      return std::abs(end[k].value - start[k].value) / std::max(start[k].scale, end[k].scale);
  throw std::logic_error("no quantity " + name);
}

}  // namespace mote::test
