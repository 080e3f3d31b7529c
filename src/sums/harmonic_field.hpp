#pragma once

#include <array>
#include <span>
#include <vector>

#include "mote/sums/harmonic_expansion.hpp"

namespace mote {

/// Adds `factor` times the derivative of a local expansion of `degree` along `axis` (0, 1, 2), in
/// units of its radius, to one of a degree less.
void add_derivative(int degree, int axis, double factor, const double* local, double* derivative);

/// Several local expansions about one centre, evaluated together at eight places at a time.
template <int functions>
class HarmonicFunctions {
 public:
  explicit HarmonicFunctions(int degree);

  /// Makes the expansion function `number`.
  void put(int number, int degree, const double* expansion);
  /// The functions at places in units of the radius from the centre.
  std::array<Lanes, functions> at(const std::array<Lanes, 3>& place) const;

 private:
  int degree_;
  std::vector<std::array<double, functions>> coefficients_;  ///< order by order
};

/// The potential of a local expansion and its gradient, of one component.
class PotentialField {
 public:
  explicit PotentialField(int degree);
  /// For the points of one node.
  void prepare(const double* local, const NodeBall& ball);
  /// The potential, then its gradient.
  std::array<Lanes, 4> at(const std::array<Lanes, 3>& point) const;

 private:
  int degree_;
  NodeBall ball_{};
  std::vector<double> slope_;
  HarmonicFunctions<4> functions_;
};

/// The curl of a vector potential, local expansions of three components, and its gradient: the
/// field of sum_j alpha_j/|x - x_j| is sum_j alpha_j x r/r^3.
class CurlField {
 public:
  explicit CurlField(int degree);
  /// For the points of one node; without `gradient`, `with_gradient` must not be called.
  void prepare(const double* local, const NodeBall& ball, bool gradient);
  std::array<Lanes, 3> at(const std::array<Lanes, 3>& point) const;
  /// The curl u, then du_a/dx_b at place 3 + 3 a + b.
  std::array<Lanes, 12> with_gradient(const std::array<Lanes, 3>& point) const;

 private:
  int degree_;
  NodeBall ball_{};
  std::vector<double> curl_, slope_;
  HarmonicFunctions<3> functions_;
  HarmonicFunctions<12> functions_and_slopes_;
};

}  // namespace mote
