#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mote/integrators/system.hpp"
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
  std::int64_t pairs = 0;        ///< pairs of neighbours visited
  std::int64_t evaluations = 0;  ///< times that lists were built
  double mean_neighbours = 0;    ///< a particle, in the last lists
};

/// A length of step that a run must not exceed, infinite if there is none, and what sets it. An
/// advisory one a run may exceed at its own risk.
struct StepLimit {
  double step;
  std::string reason;
  bool advisory = false;
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

  /// What went wrong in the steps so far without stopping them.
  virtual std::vector<std::string> warnings() const { return {}; }

  /// What the model did with the operator, and what a reader of the report should know.
  virtual PairWork pair_work() const = 0;
  virtual std::vector<std::string> remarks() const = 0;

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

/// A model's options, and how to make the model from them.
class ModelRecipe {
 public:
  virtual ~ModelRecipe() = default;
  virtual void describe(Description& description) = 0;
  virtual std::vector<InitialField> initial_fields() const = 0;
  /// The names of what `Model::conserved` will report.
  virtual std::vector<std::string> conserved_names() const = 0;
  /// Throws InputError for options that do not go together with the set-up.
  virtual std::unique_ptr<Model> make(LineSetup setup) const = 0;

  /// The same equations for moving points, by the form that converges best, as a reference on fine
  /// cells; the set-up's own operator is not used. Null if the model has none.
  virtual std::unique_ptr<Model> make_reference(LineSetup /*setup*/) const { return nullptr; }
};

}  // namespace mote
