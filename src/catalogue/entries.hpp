#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mote/exact/exact_solution.hpp"
#include "mote/exact/flow_solution.hpp"
#include "mote/integrators/integrator.hpp"
#include "mote/integrators/path.hpp"
#include "mote/models/model.hpp"
#include "mote/options/description.hpp"
#include "mote/particles/layouts.hpp"

namespace mote {

struct KernelEntry : Choice {
  /// Makes the pair terms of a fluid on the kernel; null in a dimension without them.
  std::function<std::unique_ptr<AnyFluidTerms>(std::int64_t dimension)> fluid_terms;
};

/// A differential operator: a family, and what distinguishes the members of the family, which is
/// the kernel they are built on, the degree of their polynomials, or nothing (then both are empty).
struct OperatorEntry {
  std::string family, distinction, member, summary;
  /// Makes it with default options; null if it does not exist in this dimension.
  std::function<std::unique_ptr<AnyOperator>(std::int64_t dimension)> make;

  /// The short form that a scenario may use: `sph.gauss`.
  std::string name() const { return member.empty() ? family : family + "." + member; }
};

struct IntegratorEntry : Choice {
  std::function<std::unique_ptr<Integrator>()> make;
  std::optional<double> default_tolerance;  ///< of methods that choose their steps
};

/// A path between the ends of steps, for any method.
struct PathEntry : Choice {
  std::function<std::unique_ptr<Path>()> make;
};

struct ModelEntry : Choice {
  std::function<std::unique_ptr<ModelRecipe>()> make;
};

struct LayoutEntry : Choice {
  std::function<Cells(double lower, double upper, Index count, std::uint64_t seed)> cells;
  std::function<double(Index i, Index count, std::uint64_t seed)> relative_length;
};

/// What an exact solution is made from: the model's particles and parameters at the start, and the
/// initial fields at any place, beyond the domain too.
struct ExactSetup {
  const Cloud& initial;
  Parameters parameters;
  InitialValue start;
  /// The model's reference form with every cell in this many pieces; null if it has none.
  std::function<std::unique_ptr<Model>(int pieces)> refined;
};

/// What a flow known in closed form is made from: the particles and initial fields that a model in
/// space started from, its parameters, and the particles that it made of them.
struct FlowSetup {
  const SpaceStart& start;
  Parameters parameters;
  const Cloud& initial;
};

/// An exact solution on a line, or a flow in space: one of the two is empty. Both throw InputError
/// if the solution is not one of this model with these parameters.
struct ExactEntry : Choice {
  std::vector<std::string> fields;  ///< what a `check` may set a limit for
  std::function<std::unique_ptr<ExactSolution>(const ExactSetup& setup)> make;
  std::function<std::unique_ptr<FlowSolution>(const FlowSetup& setup)> make_flow;
};

/// Everything that a scenario can name. `standard_catalogue` holds mote's own lists; a program
/// that links mote may add to it and pass it to the command line (see tests/outsider).
struct Catalogue {
  std::vector<KernelEntry> kernels;
  std::vector<OperatorEntry> operators;
  std::vector<IntegratorEntry> integrators;
  std::vector<PathEntry> paths;
  std::vector<ModelEntry> models;
  std::vector<LayoutEntry> layouts;
  std::vector<ExactEntry> exact_solutions;

  /// Makes an operator with default options; null if there is none of these names in this
  /// dimension.
  std::unique_ptr<AnyOperator> make_operator(const std::string& family, const std::string& member,
                                             std::int64_t dimension) const;

  /// Adds a kernel, and with it an operator for each of mote's families built on kernels. What is
  /// added is defined in catalogue.hpp, which includes all operators.
  template <template <int> class Kernel>
  void add_kernel();

  /// Adds an operator family that is not built on a kernel.
  template <template <int> class Family>
  void add_family();

  template <class Method>
  void add_integrator();
  template <class Way>
  void add_path();
  template <class Recipe>
  void add_model();
  template <class Layout>
  void add_layout();
};

/// A plug-in as a choice.
template <class Plugin>
Choice choice_of() {
  return {std::string(Plugin::name), std::string(Plugin::summary)};
}

/// The entries of one of the lists above as choices, and the entry that has this name.
template <class Entry>
Choices choices_of(const std::vector<Entry>& entries) {
  return {entries.begin(), entries.end()};
}

template <class Entry>
const Entry& entry_named(const std::vector<Entry>& entries, const std::string& name) {
  return *std::ranges::find(entries, name, &Entry::name);
}

/// The lists of mote: Kernels, KernelFamilies, PlainFamilies, Integrators, Models, Layouts, ...
Catalogue standard_catalogue();

}  // namespace mote
