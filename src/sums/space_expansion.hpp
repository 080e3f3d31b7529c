#pragma once

#include <span>
#include <vector>

#include "mote/sums/far_pairs.hpp"
#include "mote/sums/translation_error.hpp"

namespace mote {

/// Harmonic expansions of sum_j m_j/|x - x_j| in space, with as many components as the strengths
/// have, as the multipole method wants them; see LaurentExpansion for its counterpart in the plane.
class SpaceExpansion {
 public:
  /// `tolerance` is that of the whole sum and of its derivatives, each relative to its largest.
  SpaceExpansion(double tolerance, int components);

  /// Each thread has working memory of its own; to be called before all else.
  void make_room_for_threads();

  /// What the largest values of the next sum are at least, by derivatives; infinite where they are
  /// not wanted.
  void expect(const FarErrors& largest);

  std::size_t size() const {
    return threads_.front().coefficients() + SourcePowers::count(degree());
  }
  int degree() const { return threads_.front().degree(); }
  /// The degree that a pair of nodes needs; more than `degree()` if there is none. So many terms
  /// are taken as bring the bounds of its errors, by what the source's series holds, below its
  /// share of what the largest values allow.
  int degree_for(const double* series, const TreeNode<3>& source, const TreeNode<3>& target,
                 double distance) const;

  /// The degree of a local series, of one component, beyond which all that it holds within a radius
  /// is less than a pair of nodes may err.
  int degree_within(const double* local, double radius) const;

  /// Pairs of points that are summed in the time of one translation, as measured.
  static std::int64_t pairs_for_a_translation(int degree) { return 4 * degree * degree; }

  void add_points(const PointTree<3>& tree, Index node, std::span<const double* const> strengths,
                  double* series) const;
  void shift_up(std::span<const Child<3>> children, const TreeNode<3>& parent, double* to) const;
  void translate(std::span<const FarPair<3>> pairs, double target_radius, double* local) const;
  void shift_down(const TreeNode<3>& parent, const double* from,
                  std::span<const Child<3>> children) const;

 private:
  HarmonicExpansion& mine() const;
  /// Behind the coefficients of a multipole series stand its powers.
  double* powers_of(double* series) const { return series + threads_.front().coefficients(); }

  int components_;
  double tolerance_;
  FarErrors allowed_{};  ///< of a pair of nodes
  mutable std::vector<HarmonicExpansion> threads_;
};

}  // namespace mote
