#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mote/compare/compare_table.hpp"

namespace mote::test {

using Paths = std::vector<PathValues>;

/// A comparison whose key of refinement is a number of particles on a line.
inline Comparison comparison(const Paths& vary,
                             std::vector<ComparisonSection::Expectation> expect = {}) {
  Comparison made = comparison_of("test", {vary, std::move(expect)});
  for (Member& member : made.members) {
    member.fields = {"position", "velocity"};
    if (made.refinement) member.spacing = 1 / std::stod(member.values[*made.refinement]);
  }
  return made;
}

/// The row of a member that ran and passed with this L2 error of velocity; the other norms are
/// twice and three times that.
inline Row passed(std::size_t member, double l2) {
  Certificate run{
      .against = "sheets", .particles = 41, .steps = 10, .time = 3, .wall_seconds = 0.5};
  run.errors = {{"velocity", 2 * l2, l2, 3 * l2, 41}};
  run.conservation = {{"mass", 1, 1, 0}, {"energy", 1, 0.9, -0.1}};
  return {
      .member = member, .run = run, .updates_per_second = 820, .passed = true, .is_checked = true};
}

inline Row broken(std::size_t member, double time, const std::string& failure) {
  Certificate run{.particles = 41, .steps = 4, .time = time, .failure = failure};
  return {.member = member, .run = run};
}

inline CompareTable table_of(const Comparison& comparison, const std::vector<Row>& rows) {
  CompareTable table(comparison);
  for (const Row& row : rows) table.add(row);
  return table;
}

}  // namespace mote::test
