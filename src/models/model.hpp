#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mote/integrators/system.hpp"
#include "mote/models/space.hpp"
#include "mote/operators/differential/differential_operator.hpp"
#include "mote/options/description.hpp"
#include "mote/particles/cloud.hpp"
#include "mote/particles/extension.hpp"
#include "mote/particles/layouts.hpp"

namespace mote {

/// Whether the points move with the material or stand still.
enum class Frame { lagrangian, eulerian };

/// A quantity that the exact motion keeps. `scale` is what a drift is measured against: the sum of
/// the magnitudes that add up to `value`.
struct Conserved {
  std::string name;
  double value;
  double scale;
};

/// How much work the operator's pair sums were.
struct PairWork {
  std::int64_t pairs = 0;        ///< directed: a receiver and a neighbour within its support
  std::int64_t evaluations = 0;  ///< times that they were summed over, or listed
  double mean_neighbours = 0;    ///< pairs a particle, the last time
};

/// A length of step that a run must not exceed, infinite if there is none, and what sets it. An
/// advisory one a run may exceed at its own risk.
struct StepLimit {
  double step;
  std::string reason;
  bool advisory = false;
};

/// What a scenario may not mean as it says it, and the key of it.
struct Advice {
  std::string key, message;
};

/// A number that describes the state, with its name in tables.
struct Reading {
  std::string name;
  double value;
};

using Parameters = std::map<std::string, double>;

/// Equations of motion: the state in a cloud, and the rates at which it changes.
class Model : public System {
 public:
  virtual Cloud& cloud() = 0;
  virtual const Cloud& cloud() const = 0;
  virtual Frame frame() const = 0;

  /// What changes the state beside the rates, in halves before and after a step of the integrator
  /// (Strang splitting).
  virtual void begin_step(double /*time*/, double /*step*/) {}
  virtual void end_step(double /*time*/, double /*step*/) {}

  /// Brings fields that follow from the others up to date, after a step or a restart.
  virtual void update_dependent_fields() = 0;

  /// Throws NumericalFailure when the state is no longer one that the model can go on from.
  virtual void inspect() const = 0;

  virtual std::vector<Conserved> conserved() const = 0;

  /// The longest steps that make sense from this state on.
  virtual std::vector<StepLimit> step_limits() = 0;

  /// What the scenario may not mean as it says it.
  virtual std::vector<Advice> advice() const { return {}; }

  /// What went wrong in the steps so far without stopping them.
  virtual std::vector<std::string> warnings() const { return {}; }

  /// What the model did with the operator, and what a reader of the report should know.
  virtual PairWork pair_work() const = 0;
  virtual std::vector<std::string> remarks() const = 0;

  /// How long the next step may be for this Courant number, where the state decides on it; infinite
  /// where the scenario does.
  virtual double longest_step(double /*time*/, double /*courant*/) {
    return std::numeric_limits<double>::infinity();
  }

  /// Brings fields that no step needs up to date: those that probes look at, and all that a
  /// snapshot shows.
  virtual void complete_fields() {}
  virtual void complete_snapshot() { complete_fields(); }

  /// Tells of which time the state is that a path has put in.
  virtual void stand_at(double /*time*/) {}

  /// Forgets whatever a restart would not know: called at every snapshot, and so before the first
  /// step.
  virtual void start_afresh() {}

  /// Takes the state of a snapshot. Throws InputError if it is not one of this model.
  virtual void restore(const Cloud& state);

  /// What is worth a column in history.csv beside the conserved quantities.
  virtual std::vector<Reading> readings() const { return {}; }

  /// The bodies that the field `body` of the cloud numbers, and their spacing; empty on a line.
  virtual std::span<const Body> bodies() const { return {}; }
  virtual double spacing() const { return 0; }

  /// Force of the fluid on one of the bodies, a wall. [force; per length in 2D]
  virtual Triple force_on(std::size_t /*body*/) const { return {}; }

  /// The constants of the equations and what was chosen for them (1 or 0) by name, for an exact
  /// solution to be made from.
  virtual Parameters parameters() const = 0;
};

/// Value of an initial field, by name, at a place.
using InitialValue = std::function<double(std::string_view field, double position)>;

/// A domain on a line, its cells and what they start with.
struct LineStart {
  double lower = 0, upper = 1;
  Cells cells;
  LineEnds ends = LineEnds::zero_gradient;
  std::int64_t extension = 0;  ///< cells beyond each end
  InitialValue initial;
};

/// What a model on a line is made from.
struct LineSetup : LineStart {
  std::unique_ptr<DifferentialOperator<1>> differential_operator;
};

/// A field that the scenario's `initial` section gives, with its default; empty if required.
struct InitialField {
  std::string name;
  std::string summary;
  std::string default_expression;
};

/// Memory that belongs to no particle, and the key of the scenario that decides on it.
struct OtherMemory {
  std::string key, what;
  double bytes = 0;
};

/// A model's options, and how to make the model from them.
class ModelRecipe {
 public:
  virtual ~ModelRecipe() = default;
  virtual void describe(Description& description) = 0;
  /// Whether the model lives on a line, and not in two or three dimensions.
  virtual bool lives_on_a_line() const { return true; }
  /// Whether `time.step` alone can say how long steps are, so that without a Courant number the
  /// state does not shorten them.
  virtual bool step_suffices() const { return false; }
  /// Whether the model's `end_step` is all of a step, and leaves nothing to an integrator.
  virtual bool steps_itself() const { return false; }
  /// The largest Courant number of a step that it bears.
  virtual double largest_courant_number() const { return 1; }
  /// Whether derivatives are formed, for which a scenario must name an operator.
  virtual bool needs_operator() const { return true; }
  /// Whether particles fill a domain at a spacing, which a scenario then must give.
  virtual bool needs_domain() const { return true; }
  /// Whether its particles have what operators that need circulation need.
  virtual bool has_circulation() const { return false; }
  /// How long the sides of an outline of a wall may be where that is what the model needs, and not
  /// particles in the wall as deep as the operator reaches. [spacings]
  virtual std::optional<double> longest_side_of_walls() const { return {}; }
  virtual std::vector<InitialField> initial_fields(int dimension) const = 0;
  /// The names of what `Model::conserved` will report.
  virtual std::vector<std::string> conserved_names(int dimension) const = 0;
  /// How many particles the model itself brings in space, in place of those that fill the domain.
  virtual std::optional<double> own_particles() const { return std::nullopt; }
  /// Memory of a particle with all that belongs to it, about, in space.
  virtual double bytes_a_particle(int /*dimension*/) const { return 600; }
  /// What it needs beside its particles in this domain, whose particles are not there yet. Throws
  /// InputError for more than can be counted.
  virtual OtherMemory other_memory(const SpaceStart& /*domain*/) const { return {}; }
  /// The model on a line, or in space. Throws InputError for options that do not go together with
  /// the set-up, std::logic_error where the model does not live.
  virtual std::unique_ptr<Model> make(LineSetup setup) const;
  virtual std::unique_ptr<Model> make(SpaceSetup setup) const;

  /// The same equations for moving points, by the form that converges best, as a reference on fine
  /// cells; the set-up's own operator is not used. Null if the model has none.
  virtual std::unique_ptr<Model> make_reference(LineSetup /*setup*/) const { return nullptr; }
};

}  // namespace mote
