#pragma once

#include <complex>
#include <span>
#include <vector>

#include "mote/operators/differential/lanes.hpp"
#include "mote/sums/degree_by_ratio.hpp"
#include "mote/sums/far_pairs.hpp"
#include "mote/sums/point_tree.hpp"

namespace mote {

/// Expansions of sum_j v_j/(z - t_j) in the plane, v_j complex: about the centre c of a node of
/// radius a, with tau = (t - c)/a and zeta = (z - c)/a,
///   outside:  sum_k M_k a^k/(z - c)^(k+1),   M_k = sum_j v_j tau_j^k     (Laurent)
///   inside:   sum_l L_l zeta^l                                            (Taylor)
/// so coefficients have the size of the strengths at any scale of the coordinates. An expansion is
/// `size()` numbers: all real parts, all imaginary parts, and a Taylor series' integration constant
/// when potentials are wanted.
///
/// From (11) of Tabanjeh (2014) for both ends of a pair at once,
///   1/(d + b zeta - a tau) = 1/d sum_kl C(k+l, k) (a tau/d)^k (-b zeta/d)^l,
/// the way from M to L is a diagonal, a constant real matrix and a diagonal.
class LaurentExpansion {
 public:
  /// Terms for errors of about `tolerance` in every pair of nodes that is far enough apart.
  LaurentExpansion(double tolerance, bool with_potential);

  std::size_t size() const { return 2 * stride_ + lane_count; }

  /// The terms that a pair of nodes needs, whatever the series of the source; more than `degree()`
  /// if they are too near for any expansion.
  int degree_for(const double*, const TreeNode<2>& source, const TreeNode<2>& target,
                 double distance) const {
    return degrees_(source.radius, target.radius, distance);
  }
  int degree() const { return degrees_.degree(); }
  void make_room_for_threads() {}

  /// Pairs of points that are summed in the time of one translation, as measured.
  static std::int64_t pairs_for_a_translation(int degree) { return 4 * degree; }

  /// Adds points to a node's Laurent series: strengths are a column, or a real and an imaginary
  /// one.
  void add_points(const PointTree<2>& tree, Index node, std::span<const double* const> strengths,
                  double* series) const;
  /// Adds the Laurent series of children to their parent's.
  void shift_up(std::span<const Child<2>> children, const TreeNode<2>& parent, double* to) const;
  /// Adds the Taylor series of far nodes about a target node.
  void translate(std::span<const FarPair<2>> pairs, double target_radius, double* taylor) const;
  /// Adds a parent's Taylor series to those of its children.
  void shift_down(const TreeNode<2>& parent, const double* from,
                  std::span<const Child<2>> children) const;

  /// Values at eight places, z - c in the unit of the node's radius: f, f' times the radius, and
  /// the real part of the integral of f over the radius. [strength/length]
  struct Values {
    Lanes real{0}, imaginary{0}, slope_real{0}, slope_imaginary{0}, integral{0};
  };
  Values values(const double* taylor, const Lanes& x, const Lanes& y, bool with_slope) const;
  double constant(const double* taylor) const { return taylor[2 * stride_]; }

 private:
  void fill_binomials();
  void shift_one_up(const Child<2>& child, const TreeNode<2>& parent, double* to) const;
  void shift_one_down(const TreeNode<2>& parent, const double* from, const Child<2>& child) const;
  void shift_integral(const std::complex<double>& delta, double radius, const double* from,
                      double* to) const;
  void translate_one(const FarPair<2>& pair, double target_radius, double* taylor) const;
  void scale(const FarPair<2>& pair, const std::complex<double>& ratio, double* scaled) const;
  template <std::size_t Packs>
  void add_rows(std::size_t row, std::size_t degree, const double* scaled,
                const std::complex<double>& first, const std::complex<double>& z,
                double* taylor) const;
  double potential_of(const FarPair<2>& pair, const std::complex<double>& ratio) const;

  bool with_potential_;
  DegreeByRatio degrees_;
  std::size_t degree_;                 ///< terms of the longest expansions
  std::size_t stride_;                 ///< the same, filled up to packs of lanes
  std::vector<double> sums_;           ///< C(k + l, k): a column of `stride_` for every k
  std::vector<double> subsets_;        ///< C(l, k), columns as above
  std::vector<double> lower_subsets_;  ///< C(k, l), likewise
};

}  // namespace mote
