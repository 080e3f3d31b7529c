#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mote::test {

/// What a method's errors must look like over a ladder of numbers of steps: the order from each to
/// the next within `tolerance` of a number, the finest error at most a ceiling.
struct Ladder {
  std::vector<int> steps;
  double tolerance, ceiling;
};

/// Whether errors after these numbers of steps have this order.
template <class ErrorAfter>
testing::AssertionResult has_order(const Ladder& ladder, double order, ErrorAfter error_after) {
  double coarser = error_after(ladder.steps[0]);
  for (std::size_t level = 1; level < ladder.steps.size(); ++level) {
    const double error = error_after(ladder.steps[level]);
    const double refined = static_cast<double>(ladder.steps[level]) / ladder.steps[level - 1];
    const double observed = std::log(coarser / error) / std::log(refined);
    if (!(std::abs(observed - order) <= ladder.tolerance))
      return testing::AssertionFailure()
             << "order " << observed << " at level " << level << ", error " << error;
    coarser = error;
  }
  if (coarser <= ladder.ceiling) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "error " << coarser;
}

}  // namespace mote::test
