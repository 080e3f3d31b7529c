#include "mote/scenario/history_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

void describe_one(Description& d, HistoryCheck& check) {
  d.text({"quantity", "column of history.csv: conserved, read from the model, or of a probe", true},
         check.quantity);
  d.number({"at", "time at which a value or a bound is meant; default: the end"}, check.at,
           not_negative);
  d.number({"value", "that it must have"}, check.value);
  d.number({"most", "that it may be"}, check.most);
  d.number({"least", "that it must be"}, check.least);
  d.flag({"throughout", "whether 'most' and 'least' are meant for all rows, not for one time"},
         check.throughout);
  d.expression({"formula", "in t, that all rows must follow"}, check.formula);
  d.number({"from", "time from which rows, or points of a curve, must; default: the first row"},
           check.from, not_negative);
  d.number({"until", "time until which rows, or points of a curve, must; default: the last row"},
           check.until, not_negative);
  d.number({"decay_rate", "r of exp(-r t), by which it must fall from the first row to the last"},
           check.decay_rate);
  d.text({"file", "CSV file beside this one with a curve that it must follow"}, check.file);
  d.text({"x", "column of the file, time times scale_time plus offset_time"}, check.x);
  d.text({"y", "column of the file, the quantity times scale"}, check.y);
  d.numbers({"times", "the column x itself, in place of a file"}, check.times);
  d.numbers({"values", "the column y itself"}, check.values);
  d.number({"scale_time", "by which times become x"}, check.scale_time, positive);
  d.number({"offset_time", "x at time 0: how far the curve's clock had gone when the run starts"},
           check.offset_time);
  d.number({"scale", "by which the quantity becomes y"}, check.scale);
  d.choice({"relative_to", "what the error of a formula or curve is relative to"},
           check.relative_to,
           {{"value", "what the quantity should be there"}, {"largest", "the largest of these"}});
  d.number({"error", "largest relative error"}, check.error, positive);
}

/// What is wrong with the keys of a check together; empty if nothing is.
std::string problem_of(const HistoryCheck& check) {
  const bool comparisons[] = {check.value.has_value(), check.has_bounds(), !check.formula.empty(),
                              check.has_curve(), check.decay_rate.has_value()};
  if (std::ranges::count(comparisons, true) != 1)
    return "a check of the history needs one of: 'value', 'most' and 'least', 'formula', "
           "'decay_rate', or a curve by 'file' or by 'times' and 'values'";
  if (check.has_bounds() && check.error) return "'error' has no meaning beside 'most' and 'least'";
  if (!check.has_bounds() && !check.error) return "this check needs the largest relative 'error'";
  if (check.at && !check.value && !check.has_bounds())
    return "'at' has a meaning for a value, and for 'most' and 'least' alone";
  if (check.throughout && (!check.has_bounds() || check.at))
    return "'throughout' has a meaning for 'most' and 'least' without 'at' alone";
  if ((check.from || check.until) && check.formula.empty() && !check.has_curve() &&
      !check.throughout)
    return "'from' and 'until' have a meaning for a formula, for a curve, and with 'throughout', "
           "alone";
  if (check.from && check.until && *check.from > *check.until)
    return fmt::format("rows from {} until {} are none", *check.from, *check.until);
  if (check.value == 0.0) return "nothing is relative to 0: give 'most' and 'least' in place of it";
  if (check.decay_rate == 0.0) return "nothing is relative to the rate 0: give a 'value'";
  return "";
}

/// What is wrong with a curve for a run until `end`; empty if nothing is.
std::string problem_of_curve(const HistoryCheck& check, double end) {
  if (!check.file.empty() && (check.x.empty() || check.y.empty()))
    return "a 'file' needs the names of its columns, 'x' and 'y'";
  if (check.times.size() != check.values.size())
    return fmt::format("there are {} times and {} values", check.times.size(), check.values.size());
  const bool within = std::ranges::any_of(check.times, [&](double x) {
    const double t = check.time_at(x);
    return t >= 0 && t <= end && check.is_meant_at(t);
  });
  if (!within) return fmt::format("no point of this curve lies within the run, until t = {}", end);
  return "";
}

}  // namespace

void describe_history_checks(Description& d, std::vector<HistoryCheck>& checks) {
  describe_list(d, {"history", "what columns of history.csv must hold"}, checks,
                [&](HistoryCheck& check) { describe_one(d, check); });
}

void check_history_checks(const std::vector<HistoryCheck>& checks, double end,
                          const Constants& constants, const Document& document) {
  for (std::size_t k = 0; k < checks.size(); ++k) {
    const HistoryCheck& check = checks[k];
    const std::string section = fmt::format("check.history.{}", k);
    std::string problem = problem_of(check);
    if (problem.empty() && check.has_curve()) problem = problem_of_curve(check, end);
    if (!problem.empty()) throw LocatedError(document.locate(section), problem);
    const auto refuse_after_end = [&](const char* key, const std::optional<double>& time) {
      if (time && *time > end)
        throw LocatedError(document.locate(section + key),
                           fmt::format("the run ends at t = {}, before this", end));
    };
    refuse_after_end(".at", check.at);
    refuse_after_end(".from", check.from);
    if (check.formula.empty()) continue;
    const Expression formula(check.formula, constants);
    for (const char* place : {"x", "y", "z", "r"})
      if (formula.uses(place))
        throw LocatedError(document.locate(section + ".formula"),
                           fmt::format("a quantity of the history has no place, and this formula "
                                       "names {}",
                                       place));
  }
}

}  // namespace mote
