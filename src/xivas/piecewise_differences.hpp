#pragma once

#include <span>

namespace mote {

/// Divided differences of the exponential function by the piecewise scheme of Nadukandi 2014: the
/// recurrence where nodes are apart, and four terms of the series (99) about their mean where they
/// are close. Its worst relative errors over random nodes are 1e-13 for three nodes, 3e-11 for four
/// and 1e-9 for five; `exponential_difference` is better and serves everything but comparisons.

/// exp[x1; ...; xk], one to five nodes in any order: (106), (130), (142), (152). For three nodes
/// the series may have fewer terms, one to four, with the thresholds of (126)-(129). Throws
/// std::invalid_argument for another number of nodes or terms.
double piecewise_difference(std::span<const double> nodes, int terms = 4);

/// exp[-iy; iy; x1; ...; xk], at most three nodes x: Phi(y) of (135), (148), (158) with (161). With
/// y = 0 this is r[x1; ...; xk] as in (180)-(188). Throws std::invalid_argument for more nodes.
double piecewise_pair_difference(double y, std::span<const double> nodes);

/// exp[x1; x2; x3] as its definition stands, (81), and with the terms collected, (82): what
/// rounding spoils for close nodes.
double recursive_difference(double x1, double x2, double x3);
double collected_difference(double x1, double x2, double x3);

/// r[x1; x2; x3] by the recurrence from accurate first differences, and Phi[-x; -x; l - x] by
/// (192), x and y the real and imaginary parts of a pair of eigenvalues and l the third, with (191)
/// corrected: the usual evaluations of Tables 5 and 3.
double usual_r_difference(double x1, double x2, double x3);
double usual_pair_difference(double x, double y, double l);

}  // namespace mote
