#include "mote/app/space_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mote/app/scenario_shapes.hpp"
#include "mote/geometry/filling.hpp"
#include "mote/geometry/wall_places.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

Place place_of(const Triple& place, double time = 0) {
  return {place[0], place[1], place[2], time};
}

/// The velocity of a wall by time; empty for one that stands still.
std::function<Triple(double)> wall_velocity(const Scenario& scenario, const WallSection& wall,
                                            const std::string& name) {
  if (wall.velocity.empty()) return {};
  auto components = std::make_shared<std::vector<Expression>>();
  for (const std::string& text : wall.velocity)
    components->emplace_back(text, scenario.constants_by_name());
  return [components, name](double time) {
    Triple velocity{};
    for (std::size_t d = 0; d < components->size(); ++d) {
      velocity[d] = (*components)[d]({.t = time});
      if (!std::isfinite(velocity[d]))
        throw NumericalFailure(
            fmt::format("the velocity of the wall '{}' is not a finite number", name), {},
            "its expression has no value at this time");
    }
    return velocity;
  };
}

Body wall_body(const Scenario& scenario, const WallSection& wall, const std::string& name) {
  return {name, BodyKind::wall, wall.slips, wall_velocity(scenario, wall, name), wall.travels};
}

void add_regions(const Scenario& scenario, SpacePlan& plan) {
  for (std::size_t k = 0; k < scenario.regions.size(); ++k) {
    const RegionSection& section = scenario.regions[k];
    const std::string key = fmt::format("regions.{}", k);
    Region region{.body = {.name = section.name}, .key = key};
    if (section.is_wall()) region.body = wall_body(scenario, section, section.name);
    if (const auto side = scenario.model->longest_side_of_walls();
        side && section.is_wall() && plan.dimension == 2)
      region.body.outline = outline_of(section, *side * plan.spacing);
    region.whole = union_of(scenario, section.shapes, key + ".shapes");
    if (!section.except.empty())
      region.without = union_of(scenario, section.except, key + ".except");
    plan.regions.push_back(std::move(region));
  }
}

/// Fluid in all of the domain but the regions, which are walls.
Region fluid_around(const SpacePlan& plan, const Scenario& scenario) {
  std::vector<SharedShape> walls;
  for (const Region& wall : plan.regions)
    walls.push_back(wall.without ? std::make_shared<Difference>(wall.whole, wall.without)
                                 : wall.whole);
  Region fluid{.body = {.name = "fluid"}, .key = plan.regions.empty() ? "domain" : "regions"};
  fluid.whole = whole_domain(scenario);
  if (!walls.empty()) fluid.without = std::make_shared<Union>(std::move(walls));
  return fluid;
}

std::function<double(std::string_view, const Triple&)> initial_in_space(const Scenario& scenario) {
  auto expressions = std::make_shared<std::map<std::string, Expression, std::less<>>>();
  for (const auto& [field, text] : scenario.initial)
    expressions->emplace(field, Expression(text, scenario.constants_by_name()));
  const auto dimension = static_cast<int>(scenario.dimension);
  return [expressions, dimension](std::string_view field, const Triple& place) {
    const double value = expressions->find(field)->second(place_of(place));
    if (!std::isfinite(value))
      throw InputError("initial." + std::string(field),
                       fmt::format("'{}' is {} at {}", field,
                                   std::isnan(value) ? "not a number" : fmt::to_string(value),
                                   place_in_words(place, dimension)));
    return value;
  };
}

/// The pair terms: on the operator's kernel and smoothing length if it has a kernel, else on
/// Wendland's C2 with the operator's reach; none without an operator.
void add_terms(const Scenario& scenario, const Catalogue& catalogue, SpaceSetup& setup) {
  if (!scenario.differential_operator.is_named()) return;
  const NeighbourRule rule = scenario.differential_operator.made->neighbour_rule();
  const auto kernel = std::ranges::find(catalogue.kernels, scenario.differential_operator.member,
                                        &KernelEntry::name);
  const bool found = kernel != catalogue.kernels.end();
  setup.terms = (found ? *kernel : entry_named(catalogue.kernels, "wendland_c2"))
                    .fluid_terms(scenario.dimension);
  setup.smoothing_length = found ? rule.smoothing_length : rule.reach() / 2;
}

void refuse_bodies(const Scenario& scenario) {
  const auto refuse = [&](const std::string& key, const char* what) {
    throw InputError(key, fmt::format("the model {} brings its own particles, and knows no {}",
                                      scenario.model_type, what));
  };
  if (!scenario.domain.walls.empty()) refuse("domain.walls", "walls");
  if (!scenario.regions.empty()) refuse("regions", "regions");
}

}  // namespace

SpacePlan space_plan(const Scenario& scenario) {
  const auto& domain = scenario.domain;
  SpacePlan plan;
  plan.dimension = static_cast<int>(scenario.dimension);
  std::ranges::copy(domain.lower, plan.lower.begin());
  std::ranges::copy(domain.upper, plan.upper.begin());
  for (const std::string& axis : domain.periodic) plan.periodic[axis.front() - 'x'] = true;
  plan.spacing = scenario.particles.spacing.value_or(0);
  if (!scenario.model->longest_side_of_walls() && scenario.differential_operator.is_named())
    plan.reach = scenario.differential_operator.made->neighbour_rule().reach();
  for (const SideWallSection& wall : domain.walls) {
    const auto [axis, upper] = side_named(wall.side);
    plan.walls.push_back({wall_body(scenario, wall, wall.name), {axis, upper}});
  }
  add_regions(scenario, plan);
  const auto is_fluid = [](const RegionSection& region) { return !region.is_wall(); };
  if (std::ranges::none_of(scenario.regions, is_fluid))
    plan.regions.insert(plan.regions.begin(), fluid_around(plan, scenario));
  plan.jitter = scenario.particles.jitter.value_or(0);
  plan.seed = static_cast<std::uint64_t>(scenario.particles.seed);
  return plan;
}

SpaceStart space_start(const Scenario& scenario) {
  const bool has_own = scenario.model->own_particles().has_value();
  if (has_own) refuse_bodies(scenario);
  const SpacePlan plan = space_plan(scenario);
  Filling filling = has_own ? Filling() : filled(plan);
  SpaceStart start{.dimension = plan.dimension,
                   .lower = plan.lower,
                   .upper = plan.upper,
                   .periodic = plan.periodic,
                   .spacing = plan.spacing,
                   .bodies = std::move(filling.bodies),
                   .position = std::move(filling.position),
                   .body = std::move(filling.body),
                   .wall_places = std::move(filling.wall_places)};
  start.initial = initial_in_space(scenario);
  start.compile = [constants = scenario.constants_by_name()](const std::string& formula) {
    return [expression = std::make_shared<Expression>(formula, constants)](
               const Triple& place, double time) { return (*expression)(place_of(place, time)); };
  };
  return start;
}

SpaceSetup space_setup(Scenario& scenario, const Catalogue& catalogue) {
  SpaceSetup setup{space_start(scenario)};
  add_terms(scenario, catalogue, setup);
  setup.differential_operator = std::move(scenario.differential_operator.made);
  const std::string& search = scenario.neighbours.search;
  setup.search = search == "automatic" ? "" : search;
  setup.skin = scenario.neighbours.skin;
  return setup;
}

double memory_in_space(const Scenario& scenario) {
  const ModelRecipe& model = *scenario.model;
  const auto own = model.own_particles();
  return model.bytes_a_particle(scenario.dimension) *
         (own ? *own : most_particles(space_plan(scenario)));
}

OtherMemory other_memory_in_space(const Scenario& scenario) {
  const SpacePlan plan = space_plan(scenario);
  return scenario.model->other_memory({.dimension = plan.dimension,
                                       .lower = plan.lower,
                                       .upper = plan.upper,
                                       .periodic = plan.periodic,
                                       .spacing = plan.spacing});
}

}  // namespace mote
