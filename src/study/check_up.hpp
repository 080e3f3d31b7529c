#pragma once

#include <string>
#include <vector>

#include "mote/neighbours/neighbours.hpp"

namespace mote {

/// How good the neighbourhood of a point is.
struct Neighbourhood {
  Index neighbours = 0;
  /// Share of the support that the volumes of the point and its neighbours fill: about 1 inside,
  /// about a half at a free plane; much less where neighbours are missing. NaN for an operator that
  /// has no support but the adjacent points.
  double covered = 0;
  /// Condition number of the least-squares matrix for a parabola, columns scaled to length 1: a few
  /// units on a lattice, infinite where the neighbours do not fix a parabola.
  double condition = 0;
};

/// A value and the point that has it.
struct PointValue {
  double value = 0;
  Index point = 0;
};

/// The worst neighbourhoods of one operator on one layout.
struct CheckUpSummary {
  std::string layout, differential_operator;
  PointValue fewest, least_covered, worst_condition;  ///< the condition where it is finite
  Index without_parabola = 0;                         ///< points of infinite condition
};

CheckUpSummary summary_of(const std::vector<Neighbourhood>& neighbourhoods);

/// The neighbourhood of every receiver under an operator's rule.
template <int D>
std::vector<Neighbourhood> check_up(const Points<D>& points, const NeighbourRule& rule,
                                    const NeighbourLists& lists);

extern template std::vector<Neighbourhood> check_up(const Points<1>&, const NeighbourRule&,
                                                    const NeighbourLists&);
extern template std::vector<Neighbourhood> check_up(const Points<2>&, const NeighbourRule&,
                                                    const NeighbourLists&);
extern template std::vector<Neighbourhood> check_up(const Points<3>&, const NeighbourRule&,
                                                    const NeighbourLists&);

}  // namespace mote
