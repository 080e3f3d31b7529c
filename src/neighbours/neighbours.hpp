#pragma once

#include "mote/neighbours/lists.hpp"
#include "mote/particles/points.hpp"

namespace mote {

/// Which point's smoothing length a pair uses on a cloud of varying spacing. The paper does not
/// say; `mean` agrees with its Tables 4 and 5.
enum class PairLength { mean, scatter, gather };

/// Smoothing length of receiver i with neighbour j.
constexpr double pair_length(PairLength rule, double h_i, double h_j) {
  switch (rule) {
    case PairLength::scatter:
      return h_j;
    case PairLength::gather:
      return h_i;
    case PairLength::mean:
      break;
  }
  return 0.5 * (h_i + h_j);
}

/// A neighbour on the rim of the support counts as inside although its distance is rounded.
inline constexpr double rim_tolerance = 1 + 1e-12;

/// Which points an operator needs as neighbours: either all within `support` smoothing lengths, a
/// smoothing length being `smoothing_length` local spacings; or, where `adjacent` is not 0, the
/// next `adjacent` points on each side of an ordered line.
struct NeighbourRule {
  double support = 0;
  double smoothing_length = 1;
  PairLength length = PairLength::mean;
  Index adjacent = 0;

  /// Whether the rule accepts a pair at this distance between points of these local spacings.
  bool accepts(double distance, double spacing_i, double spacing_j) const {
    const double h = smoothing_length * pair_length(length, spacing_i, spacing_j);
    return distance <= support * h * rim_tolerance;
  }

  /// How far the rule reaches on a regular line, in spacings.
  double reach() const { return adjacent > 0 ? adjacent : support * smoothing_length; }
};

}  // namespace mote
