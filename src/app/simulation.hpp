#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mote/app/time_plan.hpp"
#include "mote/catalogue/entries.hpp"
#include "mote/observe/observer.hpp"
#include "mote/output/certificate.hpp"
#include "mote/output/snapshot.hpp"
#include "mote/scenario/scenario.hpp"

namespace mote {

/// A scenario made ready to run: the model in its initial state, the integrator, the plan of
/// steps and, if the scenario checks against one, the exact solution.
class Simulation {
 public:
  /// Throws LocatedError for input that shows itself as wrong only now: an expression without a
  /// value at a particle, an exact solution that ends before the run does, ...
  /// With `strict` everything that would be a warning is an error.
  Simulation(const Document& document, Scenario scenario, const Catalogue& catalogue, bool strict);

  const Scenario& scenario() const { return scenario_; }
  Model& model() { return *model_; }
  const Model& model() const { return *model_; }
  Integrator& integrator() { return *integrator_; }
  const Integrator& integrator() const { return *integrator_; }
  const TimePlan& plan() const { return plan_; }
  const ExactSolution* exact() const { return exact_.get(); }
  const std::string& fingerprint() const { return fingerprint_; }
  /// Memory that the run takes, about.
  double bytes_needed() const { return bytes_needed_; }
  /// run.yaml: the scenario with every default, version and threads.
  const std::string& resolved_yaml() const { return resolved_yaml_; }
  const std::vector<Conserved>& conserved_at_start() const { return conserved_at_start_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Whether the state limits the steps, and so decides how many there will be.
  bool has_steps_of_its_own() {
    return integrator_->chooses_steps() || std::isfinite(longest_step(0));
  }

  /// Whether steps know nothing of frames, and the state there is one of a path between their ends.
  bool follows_path() const { return follows_path_; }
  /// That path; null for the integrator's own.
  std::unique_ptr<Path> path() const { return make_path_ ? make_path_() : nullptr; }

  /// The next step towards a frame, the `number`-th since the last one, from `time` on: one of the
  /// plan, or as long as the state allows, where the model says so. Throws NumericalFailure.
  Step next_step(std::int64_t frame, std::int64_t number, double time);
  /// The same where steps know nothing of frames: the `number`-th of the run.
  Step next_free_step(std::int64_t number, double time);

  /// Forgets what a restart would not know: to be called at every snapshot.
  void start_afresh();

  bool has_probes() const { return observer_.has_value(); }
  /// What history.csv tells beside the conserved quantities of the state at this time.
  std::vector<Reading> observations(double time);

  /// One step of the integrator, no longer than `step`, and what the model does around it. Returns
  /// its length. Throws NumericalFailure.
  double advance(double time, double step);

  /// What the next step depends on beside the model's state.
  Restart restart(const Moment& moment) const {
    return {.step = moment.step, .time = moment.time, .integrator = integrator_->memory()};
  }

  /// Puts the model into the state of a snapshot. Throws InputError if it is of another scenario.
  void restore(const Snapshot& snapshot);

 private:
  double longest_step(double time);
  double longest_by_state(double time);
  void refuse_what_does_not_fit() const;
  void add_other_memory();
  void build(const Document& document, const Catalogue& catalogue);
  void limit_step(const Document& document);
  void warn(const std::string& where, const std::string& message);
  void make_exact(const Catalogue& catalogue);
  void make_flow(const Catalogue& catalogue);
  void refuse_early_end() const;
  void make_observer();
  void make_integrator(const Catalogue& catalogue);

  Scenario scenario_;
  std::string fingerprint_, resolved_yaml_;
  bool strict_;
  double bytes_needed_ = 0;
  TimePlan plan_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Integrator> integrator_;
  bool follows_path_ = false;
  std::function<std::unique_ptr<Path>()> make_path_;
  std::unique_ptr<ExactSolution> exact_;
  std::optional<Observer> observer_;
  std::vector<Conserved> conserved_at_start_;
  std::vector<std::string> warnings_;
};

/// Errors of the state that the simulation is in, at this time, against its exact solution.
std::vector<ErrorNorms> errors_of(const Simulation& simulation, double time);

/// The certificate of the state that the simulation is in.
Certificate certificate_of(const Simulation& simulation, const Moment& moment);

/// The certificate of a run that broke down: what it was, and no results.
Certificate failed_certificate(const Simulation& simulation, const Moment& moment,
                               const std::string& failure);

}  // namespace mote
