#include <algorithm>
#include <limits>
#include <map>

#include "mote/particles/lattice.hpp"
#include "mote/scenario/scenario.hpp"

namespace mote {
namespace {

constexpr Word<LineEnds> boundaries[] = {
    {LineEnds::zero_gradient, "zero_gradient", "cells like the end cell, (76), (84), (87)"},
    {LineEnds::held, "held", "the same, and the end particles keep what they start with, (89)"},
    {LineEnds::wall, "wall", "the gas in a mirror: nothing passes"}};

/// Whether all files must have a section, and whether such a section must have its keys: a model
/// may do without the section, and then its file may leave it out.
struct Need {
  bool section, keys;
};

Need need(const Description& d, const Scenario& scenario, bool (ModelRecipe::*needs)() const) {
  if (d.wants_all_variants()) return {false, true};
  const bool needed = !scenario.model || (scenario.model.get()->*needs)();
  return {needed, needed};
}

void describe_domain(Description& d, Scenario::Domain& domain, bool required) {
  d.numbers({"lower", "lower corner, one number a dimension", required}, domain.lower);
  d.numbers({"upper", "upper corner, one number a dimension", required}, domain.upper);
  describe_words(d, {"boundary", "on a line: what lies beyond the ends; default: zero_gradient"},
                 domain.boundary, boundaries);
  d.count(
      {"extension", "on a line: cells beyond each end (N_end_cor); default: the operator's reach"},
      domain.extension, {0, 1e6});
  d.words({"periodic", "in space: axes along which what leaves on one side comes in on the other"},
          domain.periodic,
          {{"x", "the first axis"}, {"y", "the second axis"}, {"z", "the third axis"}});
  describe_side_walls(d, domain.walls);
}

void describe_particles(Description& d, Scenario::Particles& particles,
                        const Catalogue& catalogue) {
  Choices layouts = choices_of(catalogue.layouts);
  layouts.insert(layouts.end(), lattice_layouts().begin(), lattice_layouts().end());
  d.choice({"layout", "how the points lie; default: regular, or in space lattice"},
           particles.layout, layouts);
  d.count({"count", "on a line: number of particles"}, particles.count, {2, 2e9});
  d.number({"spacing", "in space: distance between particles"}, particles.spacing, positive);
  d.number({"jitter",
            "of the jittered layout: how far fluid is moved along each axis at most, in "
            "spacings; default: 0.2"},
           particles.jitter, {0, 0.45});
  d.count({"seed", "of random layouts"}, particles.seed, not_negative);
}

void describe_model(Description& d, Scenario& scenario, const Catalogue& catalogue) {
  d.variant({"type", "equations of motion", true}, scenario.model_type,
            choices_of(catalogue.models), [&](const std::string& type) {
              if (type.empty()) return;
              if (scenario.model_type != type || !scenario.model)
                scenario.model = entry_named(catalogue.models, type).make();
              scenario.model_type = type;
              scenario.model->describe(d);
            });
}

/// Visits the models whose fields and quantities a file can name: its own, or all that there are.
void for_each_model(const Description& d, const Scenario& scenario, const Catalogue& catalogue,
                    const std::function<void(const ModelRecipe&)>& visit) {
  if (!d.wants_all_variants()) {
    if (scenario.model) visit(*scenario.model);
    return;
  }
  for (const ModelEntry& entry : catalogue.models) visit(*entry.make());
}

/// The numbers of dimensions in which fields and quantities are named.
std::vector<int> dimensions_of(const Description& d, const Scenario& scenario) {
  if (d.wants_all_variants()) return {2, 3};
  return {static_cast<int>(scenario.dimension)};
}

/// The initial fields of the model, with its defaults.
std::vector<InitialField> initial_fields(const Description& d, const Scenario& scenario,
                                         const Catalogue& catalogue) {
  std::vector<InitialField> fields;
  for_each_model(d, scenario, catalogue, [&](const ModelRecipe& model) {
    for (const int dimension : dimensions_of(d, scenario))
      for (const InitialField& field : model.initial_fields(dimension))
        if (std::ranges::find(fields, field.name, &InitialField::name) == fields.end())
          fields.push_back(field);
  });
  return fields;
}

/// Whether a file must give this field: in a schema none, for another model may do without.
bool is_required(const Description& d, const InitialField& field) {
  return !d.wants_all_variants() && field.default_expression.empty();
}

std::vector<std::string> conserved_names(const Description& d, const Scenario& scenario,
                                         const Catalogue& catalogue) {
  std::vector<std::string> names;
  for_each_model(d, scenario, catalogue, [&](const ModelRecipe& model) {
    for (const int dimension : dimensions_of(d, scenario))
      for (const std::string& name : model.conserved_names(dimension))
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  });
  return names;
}

void describe_initial(Description& d, Scenario& scenario, const std::vector<InitialField>& fields) {
  for (const InitialField& field : fields) {
    auto found = std::ranges::find(scenario.initial, field.name,
                                   &std::pair<std::string, std::string>::first);
    if (found == scenario.initial.end()) {
      scenario.initial.emplace_back(field.name, field.default_expression);
      found = std::prev(scenario.initial.end());
    }
    d.expression({field.name, field.summary, is_required(d, field)}, found->second);
  }
}

/// The largest Courant number that the model of a file bears, or any model.
double largest_courant_number(const Description& d, const Scenario& scenario) {
  if (d.wants_all_variants() || !scenario.model) return std::numeric_limits<double>::infinity();
  return scenario.model->largest_courant_number();
}

void describe_time(Description& d, Scenario& scenario, const Catalogue& catalogue) {
  Scenario::Time& time = scenario.time;
  d.choice({"integrator",
            "how time goes on; default: velocity_verlet, or none for models that make their own "
            "steps"},
           time.integrator, choices_of(catalogue.integrators));
  d.number({"courant", "in space: Courant number of a step; default: 0.25"}, time.courant,
           {0, largest_courant_number(d, scenario), true});
  d.number({"step",
            "longest time step, in space there may be none; the longest first one for integrators "
            "that choose their steps"},
           time.step, positive);
  d.number({"end", "time at which the run ends", true}, time.end, positive);
  d.number(
      {"tolerance",
       "of integrators that choose their steps: error of a step, relative to the largest value "
       "of its kind; default: the integrator's"},
      time.tolerance, {1e-15, 1});
  d.number({"longest_step", "of integrators that choose their steps; default: none"},
           time.longest_step, positive);
  Choices paths{{"none", "steps end at every snapshot"},
                {"automatic", "own, if there is one, else none"},
                {"own", "the path that the integrator itself gives between the ends of steps"}};
  for (const PathEntry& path : catalogue.paths) paths.push_back(path);
  d.choice(
      {"dense_output", "what gives the state at snapshots, so that steps know nothing of them"},
      time.dense_output, paths);
}

void describe_output(Description& d, Scenario::Output& output) {
  d.number({"every", "time between snapshots; default: a tenth of the run"}, output.every,
           positive);
  d.count({"history", "steps between rows of history.csv; 0: ten rows a snapshot"}, output.history,
          not_negative);
  d.flag({"errors",
          "whether rows of history.csv tell FIELD_error too, against the exact solution "
          "in the norm of the check"},
         output.errors);
  d.flag({"picture", "whether to draw a picture at the end"}, output.picture);
}

const Choices norms{{"l1", "sum of magnitudes"},
                    {"l2", "root of the sum of squares"},
                    {"max", "largest magnitude"}};

void describe_limit(Description& d, Scenario::Limits& limits, const std::string& name,
                    const std::string& summary) {
  auto found =
      std::ranges::find(limits, name, &std::pair<std::string, std::optional<double>>::first);
  if (found == limits.end()) {
    limits.emplace_back(name, std::nullopt);
    found = std::prev(limits.end());
  }
  d.number({name, summary}, found->second, positive);
}

void describe_checks(Description& d, Scenario::Checks& checks,
                     const std::vector<std::string>& fields,
                     const std::vector<std::string>& quantities) {
  for (const auto& field : fields)
    describe_limit(d, checks.fields, field, "largest relative error at the end");
  d.section({"drift", "largest relative drift of conserved quantities"}, [&] {
    for (const auto& quantity : quantities)
      describe_limit(d, checks.drifts, quantity, "largest relative drift");
  });
}

void describe_check(Description& d, Scenario& scenario, const Catalogue& catalogue) {
  Scenario::Check& check = scenario.check;
  const std::vector<std::string> quantities = conserved_names(d, scenario, catalogue);
  Choices solutions = choices_of(catalogue.exact_solutions);
  solutions.push_back({"nothing", "no exact solution"});
  d.variant({"against", "exact solution"}, check.against, solutions,
            [&](const std::string& against) {
              std::vector<std::string> fields;
              if (against != "nothing") {
                fields = entry_named(catalogue.exact_solutions, against).fields;
                d.choice({"norm", "of the errors of fields"}, check.norm, norms);
              }
              describe_checks(d, check.lagrangian, fields, quantities);
              std::erase(fields, "position");
              d.section({"eulerian", "limits for points that stand still, in place of the others"},
                        [&] { describe_checks(d, check.eulerian, fields, quantities); });
            });
  describe_history_checks(d, check.history);
}

}  // namespace

void describe_record(Description& d, Scenario& scenario) {
  d.text({"version", "version of mote that resolved the file; a record"}, scenario.written_by);
  d.count({"threads", "OpenMP threads; 0: all; --threads comes first"}, scenario.threads,
          {0, 4096});
}

void describe(Description& d, Scenario& scenario, const Catalogue& catalogue) {
  d.text({"name", "names the output folder and the report", true}, scenario.name);
  d.count({"dimension", "number of space dimensions", true}, scenario.dimension, {1, 3});
  d.choice({"units", "what the numbers mean"}, scenario.units,
           {{"none", "the user's own units"}, {"SI", "metres, kilograms, seconds"}});
  d.constants({"constants", "numbers that all expressions may name"}, scenario.constants);
  d.section({"model", "equations of motion", true},
            [&] { describe_model(d, scenario, catalogue); });
  const Need domain = need(d, scenario, &ModelRecipe::needs_domain);
  d.section({"domain", "where the particles are", domain.section},
            [&] { describe_domain(d, scenario.domain, domain.keys); });
  d.section({"particles", "how many, and how they lie", domain.section},
            [&] { describe_particles(d, scenario.particles, catalogue); });
  describe_regions(d, scenario.regions);
  const std::vector<InitialField> fields = initial_fields(d, scenario, catalogue);
  const bool has_required =
      std::ranges::any_of(fields, [&](const auto& field) { return is_required(d, field); });
  d.section({"initial", "state at the start, as expressions", has_required},
            [&] { describe_initial(d, scenario, fields); });
  const Need derivatives = need(d, scenario, &ModelRecipe::needs_operator);
  d.section({"operator", "how derivatives are formed", derivatives.section}, [&] {
    describe_operator(d, scenario.differential_operator, catalogue, scenario.dimension,
                      derivatives.keys);
  });
  d.section({"neighbours", "how neighbours are found"},
            [&] { describe_neighbours(d, scenario.neighbours); });
  d.section({"time", "step and end", true}, [&] { describe_time(d, scenario, catalogue); });
  d.section({"output", "what is written"}, [&] { describe_output(d, scenario.output); });
  describe_probes(d, scenario.probes);
  d.section({"check", "what the result must hold"},
            [&] { describe_check(d, scenario, catalogue); });
}

}  // namespace mote
