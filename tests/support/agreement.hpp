#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mote::test {

/// Whether `values` equal `reference` to within `tolerance` times the largest entry of the latter.
template <class Values, class Reference>
testing::AssertionResult agree(const Values& values, const Reference& reference, double tolerance) {
  if (values.size() != reference.size() || values.size() == 0)
    return testing::AssertionFailure()
           << values.size() << " values, " << reference.size() << " in the reference";
  long double largest = 0, worst = 0;
  std::size_t where = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const long double difference = std::abs(static_cast<long double>(values[i]) - reference[i]);
    largest = std::max<long double>(largest, std::abs(reference[i]));
    if (difference <= worst) continue;  // false for NaN, which is the worst
    worst = difference;
    where = i;
  }
  if (worst <= tolerance * largest) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "entry " << where << " is " << values[where] << ", the reference " << reference[where]
         << ", relative difference " << worst / largest;
}

}  // namespace mote::test
