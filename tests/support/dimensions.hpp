#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace mote::test {

/// The parameters of a typed test that runs in 1, 2 and 3 dimensions, and what such tests are
/// called.
using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;

struct NameOfDimension {
  template <class Dimension>
  static std::string GetName(int) {
    return std::to_string(Dimension::value) + "D";
  }
};

}  // namespace mote::test
