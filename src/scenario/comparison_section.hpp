#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mote/options/description.hpp"
#include "mote/scenario/document.hpp"

namespace mote {

/// The section `compare` of a scenario file: which keys `mote compare` varies, and what the
/// members must hold.
struct ComparisonSection {
  std::vector<PathValues> vary;  ///< the last key varies fastest

  /// Either the time in which the numerics must break down, or the error of a field at the finest
  /// resolution and its order.
  struct Expectation {
    std::vector<PathValues> select;  ///< varied keys with a value each; none: all members
    std::optional<double> fails_after, fails_before;
    std::string field, norm = "l2";
    std::optional<double> error, least_order, highest_order;

    bool asks_for_failure() const { return fails_after || fails_before; }
    bool asks_for_order() const { return least_order || highest_order; }
  };
  std::vector<Expectation> expect;

  bool empty() const { return vary.empty() && expect.empty(); }
};

/// Says what the section holds.
void describe_comparison(Description& description, ComparisonSection& section);

/// Refuses what no single key can state. Throws LocatedError.
void check_comparison(const ComparisonSection& section, const Document& document);

}  // namespace mote
