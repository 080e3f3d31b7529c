#include "mote/scenario/comparison_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

void describe_expectation(Description& d, ComparisonSection::Expectation& expectation) {
  d.paths({"select", "varied keys with a value each; default: all members"}, expectation.select,
          Values::one);
  d.number({"fails_after", "the numerics must break down at this time or later"},
           expectation.fails_after, not_negative);
  d.number({"fails_before", "the numerics must break down by this time"}, expectation.fails_before,
           positive);
  d.text({"field", "whose error is meant"}, expectation.field);
  d.choice({"norm", "of the error"}, expectation.norm,
           {{"l1", "sum of magnitudes"},
            {"l2", "root of the sum of squares"},
            {"max", "largest magnitude"}});
  d.number({"error", "largest relative error at the finest resolution"}, expectation.error,
           positive);
  d.number({"least_order", "of the error between the two finest resolutions"},
           expectation.least_order);
  d.number({"highest_order", "of the same"}, expectation.highest_order);
}

void check_varied(const PathValues& varied, const Document& document) {
  const Value& list = *document.find({"compare", "vary", varied.path});
  for (auto value = varied.values.begin(); value != varied.values.end(); ++value)
    if (std::find(varied.values.begin(), value, *value) != value)
      throw LocatedError(
          list.list[static_cast<std::size_t>(value - varied.values.begin())].origin.text,
          fmt::format("'{}' has the value {} twice", varied.path, *value));
}

/// What is wrong with an expectation by itself; empty if nothing is.
std::string problem_of(const ComparisonSection::Expectation& e) {
  const bool asks_for_error = e.error || e.asks_for_order();
  if (e.asks_for_failure() == asks_for_error)
    return "an expectation needs either 'fails_after' and 'fails_before', or 'error', "
           "'least_order' and 'highest_order' of a field";
  if (e.asks_for_failure() && !e.field.empty())
    return "'field' has no meaning where the numerics must break down";
  if (asks_for_error && e.field.empty()) return "an error needs a 'field', as in 'field: velocity'";
  if (e.fails_after && e.fails_before && *e.fails_after >= *e.fails_before)
    return "'fails_after' must lie before 'fails_before'";
  if (e.least_order && e.highest_order && *e.least_order > *e.highest_order)
    return "'least_order' must not lie above 'highest_order'";
  return "";
}

}  // namespace

void describe_comparison(Description& d, ComparisonSection& comparison) {
  d.section({"compare", "what mote compare varies; no run depends on it"}, [&] {
    d.paths({"vary", "key paths of this file, each with a list of values"}, comparison.vary,
            Values::several);
    describe_list(d, {"expect", "what the members must hold"}, comparison.expect,
                  [&](auto& expectation) { describe_expectation(d, expectation); });
  });
}

void check_comparison(const ComparisonSection& section, const Document& document) {
  for (const PathValues& varied : section.vary) check_varied(varied, document);
  for (std::size_t k = 0; k < section.expect.size(); ++k) {
    const std::string problem = problem_of(section.expect[k]);
    if (!problem.empty())
      throw LocatedError(document.locate(fmt::format("compare.expect.{}", k)), problem);
  }
}

}  // namespace mote
