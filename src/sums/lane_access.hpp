#pragma once

#include <cstddef>
#include <utility>

#include "mote/operators/differential/lanes.hpp"

namespace mote {

/// Calls visit(integral_constant<0>), visit(integral_constant<1>) ...: places in arrays known to
/// the compiler, so that their elements can stay in registers.
template <std::size_t Count, class Visit>
[[gnu::always_inline]] inline void unrolled(Visit visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
    (visit(std::integral_constant<std::size_t, I>{}), ...);
  }
  (std::make_index_sequence<Count>{});
}

inline Lanes load(const double* from) { return Lanes(from, std::experimental::element_aligned); }

inline void store(const Lanes& lanes, double* to) {
  lanes.copy_to(to, std::experimental::element_aligned);
}

/// The first `count` lanes, and 0 behind them.
inline Lanes first_lanes(Lanes lanes, std::size_t count) {
  const Lanes number([](auto lane) { return static_cast<double>(lane); });
  where(number >= static_cast<double>(count), lanes) = 0;
  return lanes;
}

}  // namespace mote
