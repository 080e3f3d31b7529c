#include "mote/compare/expectations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "mote/scenario/located_error.hpp"
#include "mote/scenario/suggestion.hpp"

namespace mote {
namespace {

using Expectation = ComparisonSection::Expectation;

bool selects(const Expectation& expectation, const Comparison& comparison, const Member& member) {
  return std::ranges::all_of(expectation.select, [&](const PathValues& selected) {
    const auto place = comparison.place_of(selected.path);
    return place && member.values[*place] == selected.values.front();
  });
}

/// Places of the members that an expectation selects.
std::vector<std::size_t> selected(const Expectation& expectation, const Comparison& comparison) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < comparison.members.size(); ++k)
    if (selects(expectation, comparison, comparison.members[k])) places.push_back(k);
  return places;
}

/// Of the members that differ in the key of refinement alone, the finest.
std::vector<std::size_t> finest(const std::vector<std::size_t>& places,
                                const Comparison& comparison) {
  const auto& members = comparison.members;
  const auto is_coarser = [&](std::size_t k, std::size_t other) {
    return members[other].spacing < members[k].spacing &&
           comparison.label_without_refinement(members[other]) ==
               comparison.label_without_refinement(members[k]);
  };
  std::vector<std::size_t> result;
  for (const std::size_t k : places)
    if (std::ranges::none_of(places, [&](std::size_t other) { return is_coarser(k, other); }))
      result.push_back(k);
  return result;
}

/// What is wrong with a value that an expectation selects; empty if nothing is.
std::string problem_of(const PathValues& selection, const Comparison& comparison) {
  const auto place = comparison.place_of(selection.path);
  std::vector<std::string> paths;
  for (const PathValues& varied : comparison.vary) paths.push_back(varied.path);
  if (!place)
    return fmt::format("'{}' is not varied{}", selection.path, suggestion(selection.path, paths));
  const auto& values = comparison.vary[*place].values;
  if (std::ranges::find(values, selection.values.front()) == values.end())
    return fmt::format(
        "no member has {} = {}{}; there are: {}; --set compare.expect=[] leaves all "
        "expectations out",
        selection.path, selection.values.front(), suggestion(selection.values.front(), values),
        fmt::join(values, ", "));
  return "";
}

std::string problem_of_field(const Expectation& expectation, const Comparison& comparison) {
  for (const std::size_t k : selected(expectation, comparison)) {
    const auto& fields = comparison.members[k].fields;
    if (std::ranges::find(fields, expectation.field) == fields.end())
      return fmt::format("'{}' has no error{} in {}; there are: {}", expectation.field,
                         suggestion(expectation.field, fields),
                         comparison.label(comparison.members[k]),
                         fields.empty() ? "none, for want of an exact solution"
                                        : fmt::format("{}", fmt::join(fields, ", ")));
  }
  return "";
}

/// What is wrong with an expectation in this comparison; empty if nothing is.
std::string problem_of(const Expectation& expectation, const Comparison& comparison) {
  for (const PathValues& selection : expectation.select) {
    const std::string problem = problem_of(selection, comparison);
    if (!problem.empty()) return problem;
  }
  if (expectation.asks_for_failure()) return "";
  const auto refined = comparison.refinement;
  if (expectation.asks_for_order() && (!refined || comparison.vary[*refined].values.size() < 2))
    return "an order needs two values of 'particles.count', 'particles.spacing' or 'time.step', "
           "and none is varied";
  return problem_of_field(expectation, comparison);
}

/// At most and at least, where they are asked for.
struct Limits {
  std::optional<double> most, least;
};

void add(std::vector<CheckResult>& results, const std::string& name, std::optional<double> value,
         const Limits& limits) {
  const double known = value.value_or(std::nan(""));
  if (limits.least) results.push_back({name, known, *limits.least, CheckResult::Sense::at_least});
  if (limits.most) results.push_back({name, known, *limits.most});
}

void add_failure(const Expectation& expectation, const CompareTable& table, std::size_t member,
                 std::vector<CheckResult>& results) {
  const Row* row = table.of(member);
  const std::string name = table.comparison().label(table.comparison().members[member]);
  const bool failed = row != nullptr && row->broke_down();
  add(results, name + ": time of failure", failed ? std::optional(row->run->time) : std::nullopt,
      {expectation.fails_before, expectation.fails_after});
}

void add_errors(const Expectation& expectation, const CompareTable& table, std::size_t member,
                std::vector<CheckResult>& results) {
  const Row* row = table.of(member);
  const Norm& norm = norm_named(expectation.norm);
  const std::string name =
      fmt::format("{}: {} {}", table.comparison().label(table.comparison().members[member]),
                  expectation.field, expectation.norm);
  const ErrorNorms* error = row != nullptr ? row->error(expectation.field) : nullptr;
  add(results, name + " error", error != nullptr ? std::optional(error->*norm.value) : std::nullopt,
      {expectation.error, std::nullopt});
  add(results, name + " order",
      row != nullptr ? table.order(*row, expectation.field, norm) : std::nullopt,
      {expectation.highest_order, expectation.least_order});
}

}  // namespace

void check_expectations(const Comparison& comparison, const Document& document) {
  for (std::size_t k = 0; k < comparison.expect.size(); ++k) {
    const std::string problem = problem_of(comparison.expect[k], comparison);
    if (!problem.empty())
      throw LocatedError(document.locate(fmt::format("compare.expect.{}", k)), problem);
  }
}

std::vector<CheckResult> expectation_results(const CompareTable& table) {
  std::vector<CheckResult> results;
  const Comparison& comparison = table.comparison();
  for (const Expectation& expectation : comparison.expect) {
    const auto members = selected(expectation, comparison);
    if (expectation.asks_for_failure())
      for (const std::size_t k : members) add_failure(expectation, table, k, results);
    else
      for (const std::size_t k : finest(members, comparison))
        add_errors(expectation, table, k, results);
  }
  return results;
}

bool must_fail(const Comparison& comparison, const Member& member) {
  return std::ranges::any_of(comparison.expect, [&](const Expectation& expectation) {
    return expectation.asks_for_failure() && selects(expectation, comparison, member);
  });
}

bool members_passed(const CompareTable& table) {
  const auto& members = table.comparison().members;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Row* row = table.of(k);
    if (!must_fail(table.comparison(), members[k]) && (row == nullptr || !row->passed))
      return false;
  }
  return true;
}

}  // namespace mote
