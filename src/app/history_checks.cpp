#include "mote/app/history_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mote/input/point_table.hpp"
#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/suggestion.hpp"

namespace mote {
namespace {

/// A column of history.csv as a function of time.
struct Curve {
  std::span<const double> time, value;

  /// Linear between rows; NaN outside of them.
  double at(double t) const {
    const auto above = std::ranges::lower_bound(time, t);
    if (above == time.end()) return std::numeric_limits<double>::quiet_NaN();
    const auto k = static_cast<std::size_t>(above - time.begin());
    if (time[k] == t) return value[k];
    if (k == 0) return std::numeric_limits<double>::quiet_NaN();
    return std::lerp(value[k - 1], value[k], (t - time[k - 1]) / (time[k] - time[k - 1]));
  }
};

/// The largest error of values against what they should be. NaN, the error of a value that is not
/// there, is larger than all others.
double largest_error(const std::vector<double>& values, const std::vector<double>& expected,
                     const std::string& relative_to) {
  double largest = 0, worst = 0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double size = relative_to == "largest" ? largest : std::abs(expected[k]);
    const double error = std::abs(values[k] - expected[k]) / size;
    if (std::isnan(error)) return error;
    worst = std::max(worst, error);
  }
  return worst;
}

/// The largest value of all rows that a check is meant for, times the sign. NaN, and none, are
/// larger than all others.
double largest_of(double sign, const HistoryCheck& check, const Curve& curve) {
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < curve.time.size(); ++k) {
    if (!check.is_meant_at(curve.time[k])) continue;
    if (std::isnan(curve.value[k])) return curve.value[k];
    largest = std::max(largest, sign * curve.value[k]);
  }
  return std::isfinite(largest) ? largest : std::numeric_limits<double>::quiet_NaN();
}

double error_of_formula(const HistoryCheck& check, const Curve& curve, const Constants& constants) {
  const Expression formula(check.formula, constants);
  std::vector<double> values, expected;
  for (std::size_t k = 0; k < curve.time.size(); ++k) {
    const double t = curve.time[k];
    if (!check.is_meant_at(t)) continue;
    values.push_back(curve.value[k]);
    expected.push_back(formula({.t = t}));
  }
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();  // nothing to hold
  return largest_error(values, expected, check.relative_to);
}

/// Over the points of the reference that lie within the run, where the check is meant.
double error_of_curve(const HistoryCheck& check, const Curve& curve) {
  std::vector<double> values, expected;
  for (std::size_t k = 0; k < check.times.size(); ++k) {
    const double t = check.time_at(check.times[k]);
    if (t < curve.time.front() || t > curve.time.back() || !check.is_meant_at(t)) continue;
    values.push_back(curve.at(t) * check.scale);
    expected.push_back(check.values[k]);
  }
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();  // nothing to hold
  return largest_error(values, expected, check.relative_to);
}

double error_of_rate(const HistoryCheck& check, const Curve& curve) {
  const double fall = std::log(curve.value.front() / curve.value.back());
  const double rate = fall / (curve.time.back() - curve.time.front());
  return std::abs(rate / *check.decay_rate - 1);
}

std::string label_of(const HistoryCheck& check) {
  const std::string& name = check.quantity;
  const std::string when = check.at ? fmt::format(" at t = {:.6g}", *check.at) : " at the end";
  if (check.throughout) return name + " at all times";
  if (check.has_bounds()) return name + when;
  if (check.value) return fmt::format("{}{}, relative error to {:.6g}", name, when, *check.value);
  if (check.decay_rate)
    return fmt::format("{}, relative error of the decay rate {:.6g}", name, *check.decay_rate);
  if (!check.formula.empty()) return fmt::format("{}, relative error to {}", name, check.formula);
  return fmt::format(
      "{}, relative error to {}{}", name, check.file.empty() ? "the given values" : check.file,
      check.offset_time == 0 ? "" : fmt::format(" from its time {:.6g} on", check.offset_time));
}

void append_results(const HistoryCheck& check, const Curve& curve, const Constants& constants,
                    std::vector<CheckResult>& results) {
  const std::string label = label_of(check);
  const double there = check.at ? curve.at(*check.at) : curve.value.back();
  const auto value = [&](double sign) {
    return check.throughout ? sign * largest_of(sign, check, curve) : there;
  };
  if (check.most) results.push_back({label, value(1), *check.most});
  if (check.least)
    results.push_back({label, value(-1), *check.least, CheckResult::Sense::at_least});
  if (!check.error) return;
  double error = 0;
  if (check.value)
    error = std::abs(there / *check.value - 1);
  else if (check.decay_rate)
    error = error_of_rate(check, curve);
  else
    error = check.formula.empty() ? error_of_curve(check, curve)
                                  : error_of_formula(check, curve, constants);
  results.push_back({label, error, *check.error});
}

/// A list of numbers as a document holds it, written where `origin` says.
Value list_of(const std::vector<double>& numbers, const Origin& origin) {
  Value list{.kind = Value::Kind::list, .origin = origin};
  for (const double number : numbers)
    list.list.push_back(
        {.kind = Value::Kind::word, .word = fmt::format("{}", number), .origin = origin});
  return list;
}

/// Puts the numbers of the file beside its name, if it is named and they are not there.
void read_curve(Value& check, const std::filesystem::path& folder) {
  const Value *file = check.find("file"), *x = check.find("x"), *y = check.find("y");
  const bool given = file != nullptr && x != nullptr && y != nullptr && !file->word.empty();
  if (!given || check.find("times") != nullptr || check.find("values") != nullptr) return;
  const Origin origin = file->origin;
  try {
    const PointTable table = read_csv_numbers(folder / file->word);
    const auto copy = [&](const Value& name) {
      const auto column = table.column(name.word);
      return list_of({column.begin(), column.end()}, origin);
    };
    Value times = copy(*x), values = copy(*y);
    check.entries.push_back({"times", origin, std::move(times)});
    check.entries.push_back({"values", origin, std::move(values)});
  } catch (const InputError& problem) {
    throw LocatedError(origin.text, problem.what());
  }
}

}  // namespace

void read_reference_curves(Document& document, const std::filesystem::path& folder) {
  const Value* list = document.find({"check", "history"});
  if (list == nullptr || list->kind != Value::Kind::list) return;
  Value filled = *list;
  for (Value& check : filled.list) read_curve(check, folder);
  const Origin origin = filled.origin;
  document.set({"check", "history"}, std::move(filled), origin);
}

void refuse_unknown_quantities(const std::vector<HistoryCheck>& checks,
                               const std::vector<std::string>& columns) {
  for (std::size_t k = 0; k < checks.size(); ++k) {
    const std::string& quantity = checks[k].quantity;
    if (std::ranges::find(columns, quantity) == columns.end())
      throw InputError(fmt::format("check.history.{}.quantity", k),
                       fmt::format("history.csv has no column '{}'{}; there are: {}", quantity,
                                   suggestion(quantity, columns), fmt::join(columns, ", ")));
  }
}

std::vector<CheckResult> history_results(const Scenario& scenario,
                                         const std::filesystem::path& history) {
  std::vector<CheckResult> results;
  if (scenario.check.history.empty()) return results;
  const PointTable table = read_csv_numbers(history);
  for (const HistoryCheck& check : scenario.check.history)
    append_results(check, {table.column("time"), table.column(check.quantity)},
                   scenario.constants_by_name(), results);
  return results;
}

}  // namespace mote
