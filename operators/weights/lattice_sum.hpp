#pragma once

#include <cmath>

#include "mote/neighbours/neighbours.hpp"
#include "mote/particles/vector.hpp"

namespace mote {

/// Sum of `term(distance)` over all points of a lattice of unit spacing but its origin, up to a
/// distance.
template <int D, class Term>
double lattice_sum(double radius, Term term) {
  const int most = static_cast<int>(std::ceil(radius));
  double sum = 0;
  Eigen::Matrix<int, D, 1> k = Eigen::Matrix<int, D, 1>::Constant(-most);
  for (;;) {
    const double distance = k.template cast<double>().norm();
    if (!k.isZero() && distance <= radius * rim_tolerance) sum += term(distance);
    int d = 0;
    while (d < D && ++k[d] > most) k[d++] = -most;
    if (d == D) return sum;
  }
}

}  // namespace mote
