#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "mote/sums/laurent_expansion.hpp"
#include "mote/sums/space_expansion.hpp"

namespace mote {

/// The series of far fields in D dimensions.
template <int D>
using FarExpansion = std::conditional_t<D == 2, LaurentExpansion, SpaceExpansion>;

/// What becomes of the series at the leaves of the targets' tree, and of what is too near for any.
class LeafSums {
 public:
  virtual ~LeafSums() = default;
  /// Adds the values of a Taylor series at the points of a leaf.
  virtual void add_far(Index leaf, const double* taylor) = 0;
  /// Adds values there from source points, pair by pair.
  virtual void add_near(Index leaf, std::span<const PointRange> sources) = 0;
};

/// The points of a sum, and their sources' strengths in the order of the tree.
template <int D>
struct TreePair {
  const PointTree<D>& targets;
  const PointTree<D>& sources;
  std::span<const double* const> strengths;  ///< columns
  double least_gap = 0;  ///< nodes that are nearer are no far pairs: the reach of blobs' cores
};

/// A fast multipole method (Greengard & Rokhlin 1987) on adaptive trees: far pairs of nodes are
/// summed by expansions, near leaves pair by pair. Who is far follows from the nodes' balls alone
/// (dual tree traversal, Dehnen 2002), and is found from the side of the targets: each target node
/// has one writer, which goes through its sources in the order of the tree. So results do not
/// depend on the number of threads.
template <int D>
class MultipoleSum {
 public:
  explicit MultipoleSum(FarExpansion<D> expansion) : expansion_(std::move(expansion)) {}

  FarExpansion<D>& expansion() { return expansion_; }
  void evaluate(const TreePair<D>& points, LeafSums& leaves);

 private:
  double* series_of(Index n) {
    return series_.data() + static_cast<std::size_t>(n) * expansion_.size();
  }
  void gather(const TreePair<D>& points, Index n);

  class Descent;

  FarExpansion<D> expansion_;
  std::vector<double> series_;  ///< of the source nodes
};

extern template class MultipoleSum<2>;
extern template class MultipoleSum<3>;

}  // namespace mote
