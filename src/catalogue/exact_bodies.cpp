#include "mote/catalogue/exact_bodies.hpp"

#include <stdexcept>

#include "mote/exact/homologous_collapse.hpp"
#include "mote/exact/kepler_pair.hpp"
#include "mote/exact/return_to_start.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

template <class Solution>
[[noreturn]] void refuse(const std::string& problem) {
  throw InputError("check.against", std::string(Solution::name) + " " + problem);
}

std::vector<double> copy(std::span<const double> values) { return {values.begin(), values.end()}; }

/// The parameters of bodies that pull each other; all others are refused.
template <class Solution>
const Parameters& parameters_of_bodies(const FlowSetup& setup) {
  const Parameters& parameters = setup.parameters;
  if (!parameters.contains("clusters")) refuse<Solution>("is a solution of the model bodies alone");
  if (parameters.at("gravitational_constant") == 0)
    refuse<Solution>("needs a 'gravitational_constant' above 0");
  return parameters;
}

std::unique_ptr<FlowSolution> collapse_from(const FlowSetup& setup) {
  const Parameters& parameters = parameters_of_bodies<HomologousCollapse>(setup);
  const auto of = [&](const char* name) { return parameters.at(name); };
  if (setup.start.dimension != 3 || of("clusters") != 1 || of("single_masses") != 0 ||
      of("is_ball_0") == 0)
    refuse<HomologousCollapse>(
        "needs one cluster 'uniform_ball' in 3 dimensions and no other body");
  return std::make_unique<HomologousCollapse>(
      ColdBall{.gravitational_constant = of("gravitational_constant"),
               .mass = of("mass_0"),
               .radius = of("radius_0"),
               .centre = {of("x_0"), of("y_0"), of("z_0")},
               .velocity = {of("velocity_x_0"), of("velocity_y_0"), of("velocity_z_0")},
               .position = copy(setup.initial.position())});
}

std::unique_ptr<FlowSolution> kepler_from(const FlowSetup& setup) {
  const Parameters& parameters = parameters_of_bodies<KeplerPair>(setup);
  if (setup.start.dimension != 3 || parameters.at("bodies") != 2)
    refuse<KeplerPair>("needs two bodies in 3 dimensions, and there are " +
                       std::to_string(setup.initial.count()) + " in " +
                       std::to_string(setup.start.dimension));
  if (parameters.at("core_size") != 0) refuse<KeplerPair>("is for points, and these are softened");
  TwoBodies bodies{.gravitational_constant = parameters.at("gravitational_constant")};
  for (std::size_t k = 0; k < 2; ++k) {
    bodies.mass[k] = setup.initial.values("mass")[k];
    for (std::size_t d = 0; d < 3; ++d) {
      bodies.position[k][d] = setup.initial.position()[3 * k + d];
      bodies.velocity[k][d] = setup.initial.values("velocity")[3 * k + d];
    }
  }
  try {
    return std::make_unique<KeplerPair>(bodies);
  } catch (const std::domain_error& problem) {
    refuse<KeplerPair>(problem.what());
  }
}

std::unique_ptr<FlowSolution> start_from(const FlowSetup& setup) {
  parameters_of_bodies<ReturnToStart>(setup);
  return std::make_unique<ReturnToStart>(static_cast<std::size_t>(setup.start.dimension),
                                         copy(setup.initial.position()),
                                         copy(setup.initial.values("velocity")));
}

}  // namespace

std::vector<ExactEntry> bodies_entries() {
  const std::vector<std::string> fields{"position", "velocity"};
  return {{choice_of<HomologousCollapse>(), fields, {}, collapse_from},
          {choice_of<KeplerPair>(), fields, {}, kepler_from},
          {choice_of<ReturnToStart>(), fields, {}, start_from}};
}

}  // namespace mote
