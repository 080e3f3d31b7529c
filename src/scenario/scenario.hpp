#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mote/catalogue/entries.hpp"
#include "mote/options/description.hpp"
#include "mote/scenario/comparison_section.hpp"
#include "mote/scenario/document.hpp"
#include "mote/scenario/expression.hpp"
#include "mote/scenario/history_checks.hpp"
#include "mote/scenario/operator_choice.hpp"
#include "mote/scenario/probes.hpp"
#include "mote/scenario/space_sections.hpp"

namespace mote {

/// One YAML file, checked, with every default filled in.
struct Scenario {
  std::string written_by;    ///< version of mote that resolved the file; a record
  std::int64_t threads = 0;  ///< 0: as many as the machine has

  std::string name;
  std::int64_t dimension = 0;
  std::string units = "none";
  std::vector<std::pair<std::string, double>> constants;

  struct Domain {
    std::vector<double> lower, upper;
    std::optional<LineEnds> boundary;       ///< on a line
    std::optional<std::int64_t> extension;  ///< cells beyond each end, on a line
    std::vector<std::string> periodic;      ///< axes, in space
    std::vector<SideWallSection> walls;     ///< in space
  } domain;

  struct Particles {
    std::string layout;
    std::optional<std::int64_t> count;  ///< on a line
    std::optional<double> spacing;      ///< in space
    std::optional<double> jitter;       ///< of a jittered layout, in spacings
    std::int64_t seed = 0;
  } particles;

  std::vector<RegionSection> regions;  ///< in space

  std::string model_type;
  std::unique_ptr<ModelRecipe> model;
  std::vector<std::pair<std::string, std::string>> initial;  ///< field, expression

  OperatorChoice differential_operator;
  NeighboursSection neighbours;

  struct Time {
    std::string integrator;         ///< empty for models that make their own steps
    std::optional<double> courant;  ///< Courant number of a step, in space
    std::optional<double> step;     ///< longest step; in space there may be none
    double end = 0;
    /// Of integrators that choose their steps, for which `step` is the longest first one.
    std::optional<double> tolerance, longest_step;
    std::string dense_output = "none";  ///< what gives the state at snapshots
  } time;

  struct Output {
    std::optional<double> every;  ///< time between snapshots
    std::int64_t history = 0;     ///< steps between rows of history.csv
    bool errors = false;          ///< whether they tell the errors against the exact solution
    bool picture = true;
  } output;

  std::vector<Probe> probes;

  /// Limits by name; a name without a limit is not checked.
  using Limits = std::vector<std::pair<std::string, std::optional<double>>>;
  struct Checks {
    Limits fields;  ///< relative errors at the end
    Limits drifts;  ///< relative drifts of conserved quantities

    bool has_limits() const;
  };
  struct Check {
    std::string against = "nothing";
    std::string norm = "l2";  ///< of the errors of fields
    Checks lagrangian;        ///< for points that move with the material
    Checks eulerian;  ///< for points that stand still, if it has limits; else the others hold

    std::vector<HistoryCheck> history;

    const Checks& of(Frame frame) const;
  } check;

  ComparisonSection compare;  ///< for `mote compare` alone; no run depends on it

  /// Lengths of the domain along its periodic axes, 0 along others.
  Triple periods() const;

  Constants constants_by_name() const { return {constants.begin(), constants.end()}; }
};

/// Says what a scenario file holds, but for what a run does not depend on: version, threads and the
/// section `compare`; the entries come from the catalogue.
void describe(Description& description, Scenario& scenario, const Catalogue& catalogue);

/// Says how a scenario was run: the keys `version` and `threads`.
void describe_record(Description& description, Scenario& scenario);

/// Reads and checks a document. Throws LocatedError.
Scenario read_scenario(const Document& document, const Catalogue& catalogue);

/// The scenario as YAML with every default, version and threads. Reading the result gives the
/// same scenario.
std::string resolved_yaml(Scenario& scenario, const Catalogue& catalogue);

/// A number that tells resolved scenarios apart, whatever version and threads they ran with.
std::string fingerprint(Scenario& scenario, const Catalogue& catalogue);

}  // namespace mote
