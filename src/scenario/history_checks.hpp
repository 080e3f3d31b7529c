#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mote/options/description.hpp"
#include "mote/scenario/document.hpp"
#include "mote/scenario/expression.hpp"

namespace mote {

/// One of the list `check.history`: what a column of history.csv must hold. It is compared with one
/// of: a value, bounds, a formula in t, a curve of points, or a rate of decay.
struct HistoryCheck {
  std::string quantity;      ///< the column
  std::optional<double> at;  ///< time at which a value or a bound is meant; none: at the end
  std::optional<double> value, most, least, decay_rate;
  bool throughout = false;  ///< whether bounds hold in every row, and not at one time
  std::string formula;
  std::optional<double> from, until;  ///< where rows must follow the formula or the curve, or keep
                                      ///< the bounds; none: from the first, until the last
  /// The curve: columns x and y of a CSV file, or numbers. Numbers come first: with them the file
  /// is where they are from, which is how run.yaml has it.
  std::string file, x, y;
  std::vector<double> times, values;
  double scale_time = 1, offset_time = 0;  ///< x = scale_time t + offset_time
  double scale = 1;                        ///< y = scale times the quantity
  std::string relative_to = "value";
  std::optional<double> error;  ///< largest relative error

  /// The time t that x means.
  double time_at(double x) const { return (x - offset_time) / scale_time; }
  /// Whether the check is meant for time t.
  bool is_meant_at(double t) const { return !(from && t < *from) && !(until && t > *until); }
  bool has_bounds() const { return most || least; }
  bool has_curve() const { return !file.empty() || !times.empty() || !values.empty(); }
};

/// Says what the list holds.
void describe_history_checks(Description& description, std::vector<HistoryCheck>& checks);

/// Refuses what no single key can state, for a run until `end`. Throws LocatedError.
void check_history_checks(const std::vector<HistoryCheck>& checks, double end,
                          const Constants& constants, const Document& document);

}  // namespace mote
