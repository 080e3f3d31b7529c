#include "mote/app/simulation.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "mote/app/history_checks.hpp"
#include "mote/app/line_setup.hpp"
#include "mote/app/physical_memory.hpp"
#include "mote/app/space_setup.hpp"
#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

/// Memory of a run, about. Throws InputError where the particles cannot be counted.
double memory_of(const Scenario& scenario) {
  return scenario.model->lives_on_a_line() ? memory_on_a_line(scenario) : memory_in_space(scenario);
}

/// Of models that make their own steps.
class NoIntegrator final : public Integrator {
 public:
  void advance_one_step(System& /*system*/, double /*time*/, double /*step*/) override {}
};

std::string particles_in_words(const Scenario& scenario) {
  if (const auto own = scenario.model->own_particles()) return fmt::format("{} bodies", *own);
  if (scenario.particles.count) return fmt::format("{} particles", *scenario.particles.count);
  return fmt::format("particles {} apart", *scenario.particles.spacing);
}

void refuse_operators_that_do_not_fit(const Scenario& scenario) {
  if (!scenario.differential_operator.is_named()) return;
  const AnyOperator& made = *scenario.differential_operator.made;
  const std::string name = scenario.differential_operator.name();
  const NeighbourRule rule = made.neighbour_rule();
  if (rule.adjacent == 0 && rule.reach() <= 1)
    throw InputError("operator.smoothing_length",
                     fmt::format("{} reaches {:.3g} spacings at this smoothing length: it has no "
                                 "neighbours",
                                 name, rule.reach()));
  if (made.needs_circulation() && !scenario.model->has_circulation())
    throw InputError("operator",
                     fmt::format("{} needs points with circulation, which the model {} has not",
                                 name, scenario.model_type));
}

void refuse_integrators_that_do_not_fit(const Scenario& scenario, const Integrator& integrator,
                                        Model& model) {
  const auto& [name, type] = std::tie(scenario.time.integrator, scenario.model_type);
  const std::string missing = integrator.missing_in(model);
  if (!missing.empty())
    throw InputError("time.integrator",
                     fmt::format("{} does not suit the model {} as it is set up: "
                                 "it needs {}",
                                 name, type, missing));
  if (integrator.chooses_steps() && !model.bears_any_step())
    throw InputError(
        "time.integrator",
        fmt::format("{} chooses its steps, which the model {} must know before", name, type));
  if (integrator.chooses_steps()) return;
  if (scenario.time.tolerance)
    throw InputError("time.tolerance",
                     fmt::format("{} does not control its error, so it has no tolerance", name));
  if (scenario.time.longest_step)
    throw InputError("time.longest_step",
                     fmt::format("{} does not choose its steps: 'step' is the longest", name));
}

void refuse_paths_that_there_are_not(const Scenario& scenario, const Integrator& integrator,
                                     const Model& model) {
  const std::string& path = scenario.time.dense_output;
  if (path == "none" || path == "automatic") return;
  if (!model.has_paths())
    throw InputError(
        "time.dense_output",
        fmt::format("the state of the model {} as it is set up is more than values on a "
                    "path, so its steps have to end at snapshots",
                    scenario.model_type));
  if (path != "own" && !model.falls_freely())
    throw InputError("time.dense_output",
                     fmt::format("{} needs accelerations that depend on time and places alone, "
                                 "which the model {} has not",
                                 path, scenario.model_type));
  if (path == "own" && !integrator.has_path())
    throw InputError("time.dense_output",
                     fmt::format("{} has no path of its own between the ends of its steps",
                                 scenario.time.integrator));
}

TimePlan plan_of(const Scenario& scenario, std::optional<double> longest_step) {
  return {longest_step.value_or(std::numeric_limits<double>::infinity()), *scenario.output.every,
          scenario.time.end};
}

}  // namespace

Simulation::Simulation(const Document& document, Scenario scenario, const Catalogue& catalogue,
                       bool strict)
    : scenario_(std::move(scenario)),
      fingerprint_(mote::fingerprint(scenario_, catalogue)),
      strict_(strict),
      plan_(plan_of(scenario_, scenario_.time.step)) {
  scenario_.threads = omp_get_max_threads();
  resolved_yaml_ = mote::resolved_yaml(scenario_, catalogue);
  try {
    bytes_needed_ = memory_of(scenario_);
    refuse_what_does_not_fit();
    add_other_memory();
    build(document, catalogue);
    if (exact_ != nullptr) bytes_needed_ += exact_->bytes_needed();
    refuse_what_does_not_fit();
  } catch (const InputError& error) {
    throw LocatedError(document.locate(error.key()), error.what(), error.key());
  }
}

void Simulation::refuse_what_does_not_fit() const {
  const double there = physical_memory();
  const bool on_a_line = scenario_.model->lives_on_a_line();
  if (bytes_needed_ > there)
    throw InputError(on_a_line ? "particles.count" : "particles.spacing",
                     fmt::format("{} need about {:.0f} GB, this machine has {:.0f}",
                                 particles_in_words(scenario_), bytes_needed_ / 1e9, there / 1e9));
}

void Simulation::add_other_memory() {
  if (scenario_.model->lives_on_a_line()) return;
  const OtherMemory other = other_memory_in_space(scenario_);
  const double there = physical_memory();
  bytes_needed_ += other.bytes;
  if (bytes_needed_ > there)
    throw InputError(other.key, fmt::format("{} needs about {:.3g} GB, this machine has {:.0f}",
                                            other.what, other.bytes / 1e9, there / 1e9));
}

void Simulation::build(const Document& document, const Catalogue& catalogue) {
  refuse_operators_that_do_not_fit(scenario_);
  const ModelRecipe& recipe = *scenario_.model;
  if (recipe.lives_on_a_line()) {
    const std::string warning = missing_neighbours(scenario_);
    if (!warning.empty()) warn(document.locate("domain.extension"), warning);
    model_ = recipe.make(line_setup(scenario_, catalogue));
  } else {
    make_flow(catalogue);
  }
  make_integrator(catalogue);
  conserved_at_start_ = model_->conserved();
  if (scenario_.time.courant && integrator_->wants_equal_steps())
    warn(document.locate("time.courant"),
         fmt::format("{} begins anew, with many evaluations, whenever the state changes its step",
                     scenario_.time.integrator));
  if (scenario_.time.step) limit_step(document);
  for (const auto& [key, message] : model_->advice()) warn(document.locate(key), message);
  if (recipe.lives_on_a_line()) make_exact(catalogue);
  make_observer();
}

void Simulation::make_integrator(const Catalogue& catalogue) {
  const std::string& name = scenario_.time.integrator;
  integrator_ = name.empty() ? std::make_unique<NoIntegrator>()
                             : entry_named(catalogue.integrators, name).make();
  refuse_integrators_that_do_not_fit(scenario_, *integrator_, *model_);
  refuse_paths_that_there_are_not(scenario_, *integrator_, *model_);
  if (scenario_.time.tolerance) integrator_->tolerate(*scenario_.time.tolerance);
  if (integrator_->chooses_steps()) plan_ = plan_of(scenario_, scenario_.time.longest_step);
  std::string path = scenario_.time.dense_output;
  if (path == "automatic") path = integrator_->has_path() && model_->has_paths() ? "own" : "none";
  follows_path_ = path != "none";
  if (follows_path_ && path != "own") make_path_ = entry_named(catalogue.paths, path).make;
}

void Simulation::warn(const std::string& where, const std::string& message) {
  if (strict_) throw LocatedError(where, message + " (a warning without --strict)");
  warnings_.push_back(fmt::format("{}: warning: {}", where, message));
}

void Simulation::limit_step(const Document& document) {
  for (const StepLimit& limit : model_->step_limits()) {
    if (*scenario_.time.step <= limit.step) continue;
    const std::string message = fmt::format("the step {} is beyond the stability limit {:.4g}: {}",
                                            *scenario_.time.step, limit.step, limit.reason);
    if (!limit.advisory) throw InputError("time.step", message);
    warn(document.locate("time.step"), message);
  }
}

/// How long the state allows the next step to be; infinite where the plan's step suffices.
/// Models on a line have no Courant number.
double Simulation::longest_step(double time) {
  const double first = scenario_.time.step.value_or(std::numeric_limits<double>::infinity());
  if (integrator_->chooses_steps() && time == 0) return std::min(first, longest_by_state(time));
  return longest_by_state(time);
}

double Simulation::longest_by_state(double time) {
  const auto& courant = scenario_.time.courant;
  if (!courant && scenario_.model->step_suffices()) return std::numeric_limits<double>::infinity();
  return model_->longest_step(time, courant.value_or(1));
}

Step Simulation::next_step(std::int64_t frame, std::int64_t number, double time) {
  const double longest = longest_step(time);
  if (std::isinf(longest) && !integrator_->chooses_steps()) return plan_.equal_step(frame, number);
  return plan_.step_within(frame, time, longest);
}

Step Simulation::next_free_step(std::int64_t number, double time) {
  const double longest = longest_step(time);
  const bool is_equal = std::isinf(longest) && scenario_.time.step;
  if (is_equal && !integrator_->chooses_steps()) return plan_.free_step(number);
  return plan_.free_step_within(
      time, integrator_->chooses_steps() ? longest : std::min(longest, plan_.every()));
}

void Simulation::start_afresh() {
  integrator_->forget_rounding();
  model_->start_afresh();
}

double Simulation::advance(double time, double step) {
  model_->begin_step(time, step);
  if (strict_ && !model_->warnings().empty())
    throw NumericalFailure(model_->warnings().front(), {},
                           "--strict makes an error of this warning");
  const double length = integrator_->advance(*model_, time, step);
  model_->end_step(time, length);
  model_->update_dependent_fields();
  model_->inspect();
  return length;
}

void Simulation::make_exact(const Catalogue& catalogue) {
  const std::string& against = scenario_.check.against;
  if (against == "nothing") return;
  const auto& solution = entry_named(catalogue.exact_solutions, against);
  if (!solution.make)
    throw InputError("check.against",
                     fmt::format("{} is a flow in space, and the model {} lives on a line", against,
                                 scenario_.model_type));
  const bool lagrangian = model_->frame() == Frame::lagrangian;
  for (const auto& [field, limit] : scenario_.check.of(model_->frame()).fields)
    if (!lagrangian && limit && field == "position")
      throw InputError("check.position",
                       "points that stand still have no error of position; give their limits in "
                       "the section 'eulerian'");
  const std::unique_ptr<Model> fine = lagrangian ? nullptr : finely_divided(scenario_, catalogue);
  const Model& start = lagrangian ? *model_ : *fine;
  const auto refined = [recipe = scenario_.model.get(), start = line_start(scenario_, catalogue)](
                           int pieces) { return recipe->make_reference({divided(start, pieces)}); };
  exact_ = solution.make({start.cloud(), start.parameters(), initial_value(scenario_), refined});
  refuse_early_end();
}

void Simulation::refuse_early_end() const {
  if (scenario_.time.end >= exact_->valid_until())
    throw InputError(
        "time.end",
        fmt::format("the exact solution {} ends at t = {:.6g}, before the run does "
                    "at t = {}",
                    scenario_.check.against, exact_->valid_until(), scenario_.time.end));
}

/// The model in space and the flow that it is compared with, which is made from the same start.
void Simulation::make_flow(const Catalogue& catalogue) {
  SpaceSetup setup = space_setup(scenario_, catalogue);
  const std::string& against = scenario_.check.against;
  if (against == "nothing") {
    model_ = scenario_.model->make(std::move(setup));
    return;
  }
  const auto& solution = entry_named(catalogue.exact_solutions, against);
  if (!solution.make_flow)
    throw InputError("check.against",
                     fmt::format("{} belongs to models on a line, and the model {} lives in space",
                                 against, scenario_.model_type));
  const SpaceStart start = setup;
  model_ = scenario_.model->make(std::move(setup));
  exact_ = std::make_unique<FlowReference>(
      solution.make_flow({start, model_->parameters(), model_->cloud()}), start.dimension);
  refuse_early_end();
}

/// The probes, and the checks of what they and the model tell.
void Simulation::make_observer() {
  if (scenario_.output.errors && exact_ == nullptr)
    throw InputError("output.errors", "there are no errors without an exact solution");
  if (!scenario_.probes.empty()) observer_.emplace(scenario_.probes, scenario_.periods(), *model_);
  std::vector<std::string> columns{"time", "step"};
  for (const Conserved& quantity : conserved_at_start_) columns.push_back(quantity.name);
  for (const Reading& reading : observations(0)) columns.push_back(reading.name);
  refuse_unknown_quantities(scenario_.check.history, columns);
}

std::vector<Reading> Simulation::observations(double time) {
  std::vector<Reading> readings = model_->readings();
  if (observer_) std::ranges::move(observer_->readings(*model_), std::back_inserter(readings));
  if (scenario_.output.errors)
    for (const ErrorNorms& error : errors_of(*this, time))
      readings.push_back({error.field + "_error", error.in_norm(scenario_.check.norm)});
  return readings;
}

void Simulation::restore(const Snapshot& snapshot) {
  if (snapshot.fingerprint != fingerprint_)
    throw InputError("this snapshot belongs to another scenario than run.yaml");
  model_->restore(snapshot.cloud);
}

}  // namespace mote
