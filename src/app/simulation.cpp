#include "mote/app/simulation.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "mote/app/history_checks.hpp"
#include "mote/app/physical_memory.hpp"
#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

/// The scenario's initial expressions as a function, with an error where one has no value.
InitialValue initial_value(const Scenario& scenario) {
  auto expressions = std::make_shared<std::map<std::string, Expression, std::less<>>>();
  for (const auto& [field, text] : scenario.initial)
    expressions->emplace(field, Expression(text, scenario.constants_by_name()));
  return [expressions](std::string_view field, double x) {
    const double value = expressions->find(field)->second({.x = x});
    if (!std::isfinite(value))
      throw InputError("initial." + std::string(field),
                       fmt::format("'{}' is {} at x = {:.6g}", field,
                                   std::isnan(value) ? "not a number" : fmt::to_string(value), x));
    return value;
  };
}

std::unique_ptr<DifferentialOperator<1>> on_a_line(std::unique_ptr<AnyOperator> any) {
  return std::unique_ptr<DifferentialOperator<1>>(
      dynamic_cast<DifferentialOperator<1>*>(any.release()));
}

/// All that a model is made from but the operator.
LineStart line_start(const Scenario& scenario, const Catalogue& catalogue) {
  LineStart setup;
  setup.lower = scenario.domain.lower[0];
  setup.upper = scenario.domain.upper[0];
  setup.ends = scenario.domain.boundary;
  setup.extension = *scenario.domain.extension;
  setup.initial = initial_value(scenario);
  const auto& layout = entry_named(catalogue.layouts, scenario.particles.layout);
  setup.cells = layout.cells(setup.lower, setup.upper, static_cast<Index>(scenario.particles.count),
                             static_cast<std::uint64_t>(scenario.particles.seed));
  const double resolution = 16 * std::numeric_limits<double>::epsilon() *
                            std::max(std::abs(setup.lower), std::abs(setup.upper));
  if (std::ranges::min(setup.cells.length) <= resolution)
    throw InputError("particles.count",
                     fmt::format("{} particles between {} and {} lie closer "
                                 "than numbers can tell",
                                 scenario.particles.count, setup.lower, setup.upper));
  return setup;
}

/// The same with every cell in this many pieces.
LineStart divided(LineStart start, int pieces) {
  Cells fine;
  for (std::size_t i = 0; i < start.cells.centre.size(); ++i)
    for (int k = 0; k < pieces; ++k) {
      const double part = (k + 0.5) / pieces - 0.5;
      fine.centre.push_back(start.cells.centre[i] + part * start.cells.length[i]);
      fine.length.push_back(start.cells.length[i] / pieces);
    }
  start.cells = std::move(fine);
  return start;
}

/// The start of the run on finer cells. Standing points see the gas between the particles too, and
/// the particles' own cells would be too coarse a measure of that.
std::unique_ptr<Model> finely_divided(const Scenario& scenario, const Catalogue& catalogue) {
  LineStart start = line_start(scenario, catalogue);
  const int pieces = std::clamp(1'000'000 / static_cast<int>(start.cells.centre.size()), 1, 50);
  LineSetup setup{divided(std::move(start), pieces)};
  setup.differential_operator = on_a_line(catalogue.make_operator(
      scenario.differential_operator.family, scenario.differential_operator.member, 1));
  return scenario.model->make(std::move(setup));
}

/// Memory of a run on a line: fields with their rates and work arrays, and the neighbours, whose
/// lists keep as much room again for particles that come to have more.
double memory_of(const Scenario& scenario) {
  constexpr double fields = 400;
  const auto count = static_cast<double>(scenario.particles.count);
  const double reach = scenario.differential_operator.made->neighbour_rule().reach();
  return count * (fields + 2 * std::min(2 * reach, count) * static_cast<double>(sizeof(Index)));
}

}  // namespace

Simulation::Simulation(const Document& document, Scenario scenario, const Catalogue& catalogue,
                       bool strict)
    : scenario_(std::move(scenario)),
      fingerprint_(mote::fingerprint(scenario_, catalogue)),
      strict_(strict),
      bytes_needed_(memory_of(scenario_)),
      plan_(scenario_.time.step, *scenario_.output.every, scenario_.time.end) {
  scenario_.threads = omp_get_max_threads();
  resolved_yaml_ = mote::resolved_yaml(scenario_, catalogue);
  try {
    refuse_what_does_not_fit();
    build(document, catalogue);
    if (exact_ != nullptr) bytes_needed_ += exact_->bytes_needed();
    refuse_what_does_not_fit();
  } catch (const InputError& error) {
    throw LocatedError(document.locate(error.key()), error.what());
  }
}

void Simulation::refuse_what_does_not_fit() const {
  const double there = physical_memory();
  if (bytes_needed_ > there)
    throw InputError("particles.count",
                     fmt::format("{} particles need about {:.0f} GB, this machine has {:.0f}",
                                 scenario_.particles.count, bytes_needed_ / 1e9, there / 1e9));
}

void Simulation::build(const Document& document, const Catalogue& catalogue) {
  refuse_operators_that_do_not_fit(document);
  LineSetup setup{line_start(scenario_, catalogue)};
  setup.differential_operator = on_a_line(std::move(scenario_.differential_operator.made));
  model_ = scenario_.model->make(std::move(setup));
  integrator_ = entry_named(catalogue.integrators, scenario_.time.integrator).make();
  conserved_at_start_ = model_->conserved();
  limit_step(document);
  make_exact(catalogue);
  make_observer();
}

void Simulation::refuse_operators_that_do_not_fit(const Document& document) {
  const AnyOperator& made = *scenario_.differential_operator.made;
  const std::string name = scenario_.differential_operator.name();
  const std::int64_t extension = *scenario_.domain.extension;
  const NeighbourRule rule = made.neighbour_rule();
  if (rule.adjacent == 0 && rule.reach() <= 1)
    throw InputError("operator.smoothing_length",
                     fmt::format("{} reaches {:.3g} spacings at this smoothing length: it has no "
                                 "neighbours",
                                 name, rule.reach()));
  if (made.needs_circulation())
    throw InputError("operator",
                     fmt::format("{} needs points with circulation, which the model {} has not",
                                 name, scenario_.model_type));
  if (rule.adjacent > extension)
    throw InputError("domain.extension",
                     fmt::format("{} needs {} cell{} beyond each end, and 'extension' is {}", name,
                                 rule.adjacent, rule.adjacent == 1 ? "" : "s", extension));
  if (static_cast<double>(extension) < std::floor(rule.reach()))
    warn(document.locate("domain.extension"),
         fmt::format("the region goes on for {} cells beyond its ends, but the operator reaches "
                     "{:.3g}: derivatives near the ends miss neighbours",
                     extension, rule.reach()));
}

void Simulation::warn(const std::string& where, const std::string& message) {
  if (strict_) throw LocatedError(where, message + " (a warning without --strict)");
  warnings_.push_back(fmt::format("{}: warning: {}", where, message));
}

void Simulation::limit_step(const Document& document) {
  for (const StepLimit& limit : model_->step_limits()) {
    if (scenario_.time.step <= limit.step) continue;
    const std::string message = fmt::format("the step {} is beyond the stability limit {:.4g}: {}",
                                            scenario_.time.step, limit.step, limit.reason);
    if (!limit.advisory) throw InputError("time.step", message);
    warn(document.locate("time.step"), message);
  }
}

Step Simulation::next_step(std::int64_t frame, std::int64_t number, double time) {
  constexpr double courant = 0.25;
  const double longest = model_->longest_step(time, courant);
  if (std::isinf(longest)) return plan_.equal_step(frame, number);
  return plan_.step_within(frame, time, longest);
}

void Simulation::start_afresh() {
  integrator_->forget_rounding();
  model_->start_afresh();
}

void Simulation::advance(double time, double step) {
  model_->begin_step(time, step);
  if (strict_ && !model_->warnings().empty())
    throw NumericalFailure(model_->warnings().front(), {0},
                           "--strict makes an error of this warning");
  integrator_->advance_one_step(*model_, time, step);
  model_->end_step(time, step);
  model_->update_dependent_fields();
  model_->inspect();
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
  if (scenario_.time.end >= exact_->valid_until())
    throw InputError("time.end",
                     fmt::format("the exact solution {} ends at t = {:.6g}, before the run does "
                                 "at t = {}",
                                 against, exact_->valid_until(), scenario_.time.end));
}

/// The probes, and the checks of what they and the model tell.
void Simulation::make_observer() {
  const Triple period{};
  if (!scenario_.probes.empty()) observer_.emplace(scenario_.probes, period, *model_);
  std::vector<std::string> columns{"time", "step"};
  for (const Conserved& quantity : conserved_at_start_) columns.push_back(quantity.name);
  for (const Reading& reading : observations()) columns.push_back(reading.name);
  refuse_unknown_quantities(scenario_.check.history, columns);
}

std::vector<Reading> Simulation::observations() {
  std::vector<Reading> readings = model_->readings();
  if (observer_) std::ranges::move(observer_->readings(*model_), std::back_inserter(readings));
  return readings;
}

void Simulation::restore(const Snapshot& snapshot) {
  if (snapshot.fingerprint != fingerprint_)
    throw InputError("this snapshot belongs to another scenario than run.yaml");
  model_->restore(snapshot.cloud);
}

}  // namespace mote
