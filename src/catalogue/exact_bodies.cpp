#include "mote/catalogue/exact_bodies.hpp"

#include "mote/exact/homologous_collapse.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw InputError("check.against", std::string(HomologousCollapse::name) + " " + problem);
}

std::unique_ptr<FlowSolution> collapse_from(const FlowSetup& setup) {
  const Parameters& parameters = setup.parameters;
  if (!parameters.contains("clusters")) refuse("is a solution of the model bodies alone");
  const auto of = [&](const char* name) { return parameters.at(name); };
  if (setup.start.dimension != 3 || of("clusters") != 1 || of("single_masses") != 0 ||
      of("is_ball_0") == 0)
    refuse("needs one cluster 'uniform_ball' in 3 dimensions and no other body");
  if (of("gravitational_constant") == 0) refuse("needs a 'gravitational_constant' above 0");
  const auto position = setup.initial.position();
  return std::make_unique<HomologousCollapse>(
      ColdBall{.gravitational_constant = of("gravitational_constant"),
               .mass = of("mass_0"),
               .radius = of("radius_0"),
               .centre = {of("x_0"), of("y_0"), of("z_0")},
               .velocity = {of("velocity_x_0"), of("velocity_y_0"), of("velocity_z_0")},
               .position = {position.begin(), position.end()}});
}

}  // namespace

std::vector<ExactEntry> bodies_entries() {
  return {{choice_of<HomologousCollapse>(), {"position", "velocity"}, {}, collapse_from}};
}

}  // namespace mote
