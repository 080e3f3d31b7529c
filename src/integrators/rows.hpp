#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "mote/integrators/system.hpp"

namespace mote {

/// Numbers of all parts of a system, one part after the other.
using Row = std::vector<double>;

inline void append(Row& row, std::span<const double> values) {
  row.insert(row.end(), values.begin(), values.end());
}

/// What `member` (&Evolving::value or &Evolving::rate) is of all parts.
template <class Member>
Row in_a_row(std::span<const Evolving> parts, Member member) {
  Row row;
  for (const Evolving& part : parts) append(row, part.*member);
  return row;
}

/// Puts the values of all parts where they are in a row.
inline void spread(std::span<const double> row, std::span<const Evolving> parts) {
  for (const Evolving& part : parts) {
    std::copy_n(row.begin(), part.value.size(), part.value.begin());
    row = row.subspan(part.value.size());
  }
}

/// Takes the first numbers off a row that is read from its front.
inline Row take_front(std::span<const double>& row, std::size_t count) {
  const Row front(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(count));
  row = row.subspan(count);
  return front;
}

}  // namespace mote
