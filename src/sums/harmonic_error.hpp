#pragma once

#include "mote/sums/harmonic_layout.hpp"

namespace mote {

/// Where a source and a target stand to each other: radii over the distance of the centres. They
/// are apart where the sum is below 1.
struct PairRatios {
  double source, target;
};

/// What M/distance is to be multiplied by to bound the error of the potential at any point of the
/// target, for sources of sum |m_j| = M anywhere in their ball, translated with all terms of degree
/// `degree` of source and target:
///   (q^(p+1) + t^(p+1))/(1 - a - b),  q = a/(1 - b),  t = b/(1 - a).
/// Rigorous, and nearly attained where source and target are the points nearest to each other:
/// there the error is this less the terms counted twice. Points spread over their balls stay well
/// below.
double potential_error_bound(const PairRatios& ratios, int degree);

/// The same for the gradient of the potential, over M/distance^2.
double gradient_error_bound(const PairRatios& ratios, int degree);

/// The lowest degree of which potential_error_bound is at most `tolerance`; highest_degree + 1 if
/// there is none, or if the balls touch.
int degree_for(const PairRatios& ratios, double tolerance);

}  // namespace mote
