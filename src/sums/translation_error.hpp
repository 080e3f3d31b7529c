#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "mote/operators/differential/lanes.hpp"
#include "mote/sums/harmonic_expansion.hpp"

namespace mote {

/// Errors of the potential and of its first and second derivatives.
using FarErrors = std::array<double, 3>;

/// Balls of sources and targets are far from each other up to this ratio of the one's radius to the
/// distance of its centre from the other. Nearer ones would cost more terms than they save pairs.
inline constexpr double largest_ratio = 0.6;

/// How much of a source there is in each degree of its multipole expansion: what bounds the errors
/// of its translations. In a row of `count(degree)` numbers, with points at x_j from the centre of
/// a ball of radius a, in units of the strengths:
///   M = sum_j |m_j|;
///   s, the reach of degrees above the highest, k = degree + 1: M (s a)^k = sum_j |m_j| |x_j|^k;
///   P_0; the largest of P_1 ... P_degree;
///   sum_(n>p) P_n w^(n-p-1) (n+1)(n+2)/((p+2)(p+3)), w the largest ratio, p = 0 ... degree;
/// where P_n = (sum_m |M_n^m|^2)^(1/2) is the power of a degree, the same in all axes (Dehnen 2014,
/// Computational Astrophysics and Cosmology 1:1). P_n <= sum_j |m_j| |x_j|^n/a^n.
class SourcePowers {
 public:
  static std::size_t count(int degree);

  SourcePowers(const HarmonicExpansion& expansion, double* numbers)
      : degree_(expansion.degree()), components_(expansion.components()), numbers_(numbers) {}

  /// From all points of a ball and their expansion.
  void take_points(const PointColumns& points, const NodeBall& ball, const double* multipole);

  struct Child {
    const double* numbers;
    double radius, distance;  ///< from the parent's centre
  };
  /// From the children of a ball and its expansion: by the inequality of Minkowski, the reach about
  /// another centre is at most longer by the way between the two.
  void take_children(std::span<const Child> children, double radius, const double* multipole);

 private:
  void take_highest(double strength, double moment);
  void take_expansion(const double* multipole);

  int degree_, components_;
  double* numbers_;
};

/// A pair of balls: radii of source and target, and the distance of the centres.
struct PairOfBalls {
  double source, target, distance;
};

/// Whether no expansion is any good for them.
bool are_too_near(const PairOfBalls& pair);

/// Bounds of the errors at any point of the target if all terms above a degree, of source and of
/// target, are left out of a translation. They hold for every pair that is not too near.
class TranslationErrors {
 public:
  /// `powers` of an expansion of `degree`.
  TranslationErrors(const double* powers, int degree, const PairOfBalls& pair);

  /// Of the potential and of its derivatives, for the eight degrees from `first` on. Those above
  /// the highest mean nothing.
  std::array<Lanes, 3> from_degree(int first) const;
  /// The lowest degree from 3 on whose errors are at most as `allowed`; `degree` + 1 if there is
  /// none.
  int lowest_degree(const FarErrors& allowed) const;

 private:
  const double* powers_;
  int degree_;
  PairOfBalls pair_;
  double inverse_gap_, beyond_;
};

}  // namespace mote
