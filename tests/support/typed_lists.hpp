#pragma once

#include <gtest/gtest.h>

#include <string>

#include "mote/options/type_list.hpp"

namespace mote::test {

template <class List>
struct TypesOf;

template <class... T>
struct TypesOf<TypeList<T...>> {
  using type = testing::Types<T...>;
};

/// Calls each typed test by the name that its type has in a scenario.
struct NameOfType {
  template <class T>
  static std::string GetName(int) {
    return std::string(T::name);
  }
};

}  // namespace mote::test
