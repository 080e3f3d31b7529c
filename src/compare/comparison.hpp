#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mote/scenario/scenario.hpp"

namespace mote {

/// One run of a comparison.
struct Member {
  std::vector<std::string> values;  ///< of the varied keys in their order, as YAML in one line
  std::string folder;               ///< below that of the comparison, as in `runs/02-mps-41`
  double spacing = 0;               ///< what falls along the key of refinement, if there is one
  std::string unsuited;  ///< why its integrator cannot be the one of this scenario; else empty
  std::vector<std::string> fields;  ///< those that the run is compared in with an exact solution

  bool suits() const { return unsuited.empty(); }
};

/// The runs of a scenario under all combinations of the values of some of its keys.
struct Comparison {
  std::string name;
  std::vector<PathValues> vary;
  std::vector<ComparisonSection::Expectation> expect;
  std::vector<Member> members;            ///< the last key varies fastest
  std::optional<std::size_t> refinement;  ///< the varied key along which orders are observed

  /// The place of a key among those that are varied; nothing for others.
  std::optional<std::size_t> place_of(const std::string& path) const;

  /// A member in words: `operator = mps, particles.count = 41`. Without the key of refinement if it
  /// stands for a member at any resolution.
  std::string label(const Member& member) const;
  std::string label_without_refinement(const Member& member) const;
};

/// The comparison that the section `compare` of a scenario asks for.
Comparison comparison_of(const std::string& name, const ComparisonSection& section);

/// The base document with the values of a member in it, each with the place where it was written.
Document document_of(const Document& base, const Comparison& comparison, const Member& member);

/// A file that makes the same comparison again: the base document as it was given with `--set` and
/// `--vary`, without defaults, which may differ between members; only a section that `--set` added
/// a key to the short form of is taken from the resolved scenario.
std::string comparison_yaml(const Document& base, const std::string& resolved_scenario);

/// The `--set` of a member for a command line, `key=value` each.
std::vector<std::string> assignments_of(const Comparison& comparison, const Member& member);

/// The spacing or step that falls when this key is refined.
double spacing_along(const std::string& path, const Scenario& scenario);

/// Members that one comparison may have.
inline constexpr std::size_t most_members = 1000;

}  // namespace mote
