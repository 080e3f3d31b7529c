#pragma once

#include <span>
#include <vector>

#include "mote/sums/degree_by_ratio.hpp"
#include "mote/sums/far_pairs.hpp"
#include "mote/sums/harmonic_expansion.hpp"

namespace mote {

/// Harmonic expansions of sum_j m_j/|x - x_j| in space, with as many components as the strengths
/// have, as the multipole method wants them; see LaurentExpansion for its counterpart in the plane.
/// `tolerance` is that of the whole sum: pairs of nodes may err more, as they do not err together.
class SpaceExpansion {
 public:
  SpaceExpansion(double tolerance, int components);

  /// Each thread has working memory of its own; to be called before all else.
  void make_room_for_threads();

  std::size_t size() const { return threads_.front().coefficients(); }
  int degree() const { return degrees_.degree(); }
  int degree_for(double a, double b, double d) const { return degrees_(a, b, d); }

  /// Pairs of points that are summed in the time of one translation, as measured.
  static std::int64_t pairs_for_a_translation(int degree) { return 6 * degree * degree; }

  void add_points(const PointTree<3>& tree, Index node, std::span<const double* const> strengths,
                  double* series) const;
  void shift_up(std::span<const Child<3>> children, const TreeNode<3>& parent, double* to) const;
  void translate(std::span<const FarPair<3>> pairs, double target_radius, double* local) const;
  void shift_down(const TreeNode<3>& parent, const double* from,
                  std::span<const Child<3>> children) const;

 private:
  HarmonicExpansion& mine() const;

  int components_;
  DegreeByRatio degrees_;
  mutable std::vector<HarmonicExpansion> threads_;
};

}  // namespace mote
