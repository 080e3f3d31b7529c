#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "mote/integrators/system.hpp"

namespace mote {

/// Visits the parts of a system in the order in which its values stand in a list of all of them.
template <class Visit>
void for_each_part(System& system, Visit visit) {
  for (const Evolving& part : system.drifted()) visit(part);
  for (const Evolving& part : system.kicked()) visit(part);
}

/// All values that a system has: those that drift, then those that are kicked.
inline std::vector<double> values_of(System& system) {
  std::vector<double> values;
  for_each_part(system, [&](const Evolving& part) {
    values.insert(values.end(), part.value.begin(), part.value.end());
  });
  return values;
}

/// Gives a system the values of such a list.
inline void put_values(System& system, std::span<const double> values) {
  for_each_part(system, [&](const Evolving& part) {
    std::ranges::copy(values.first(part.value.size()), part.value.begin());
    values = values.subspan(part.value.size());
  });
}

}  // namespace mote
