#include "mote/neighbours/kd_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <stdexcept>

namespace mote {
namespace {

/// A cloud as nanoflann reads it.
template <int D>
struct Cloud {
  const Points<D>& points;

  std::size_t kdtree_get_point_count() const { return points.length.size(); }
  double kdtree_get_pt(Index i, std::size_t d) const {
    return points.position[static_cast<std::size_t>(i) * D + d];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

template <int D>
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud<D>>,
                                                 Cloud<D>, D, Index>;

/// Takes what nanoflann finds around one receiver. nanoflann offers points closer than a radius,
/// a little more than the rule reaches; the rule alone decides on them.
template <int D>
struct Neighbourhood {
  const Points<D>& points;
  const NeighbourRule& rule;
  Index receiver;
  double squared_radius;
  std::vector<Index>& list;

  bool addPoint(double squared_distance, Index j) {
    if (j != receiver &&
        rule.accepts(std::sqrt(squared_distance), points.length[receiver], points.length[j]))
      list.push_back(j);
    return true;
  }
  double worstDist() const { return squared_radius; }
  bool full() const { return true; }
  std::size_t size() const { return list.size(); }
};

/// A squared radius within which lie all neighbours of a point of length h_i: no neighbour is
/// longer than `longest`. The last term finds coincident points although the rule's reach is 0.
double squared_radius(const NeighbourRule& rule, double h_i, double longest) {
  const double reach =
      rule.support * rule.smoothing_length * pair_length(rule.length, h_i, longest);
  const double widened = reach * (1 + 1e-9);
  return widened * widened + std::numeric_limits<double>::min();
}

/// The search of one cloud.
template <int D>
class Search {
 public:
  Search(const Points<D>& points, const NeighbourRule& rule)
      : points_(points), rule_(rule), cloud_{points}, tree_(D, cloud_) {
    for (const double length : points.length) longest_ = std::max(longest_, length);
  }

  /// Puts the neighbours of receiver i into a list.
  void find(Index i, std::vector<Index>& list) const {
    list.clear();
    Neighbourhood<D> found{points_, rule_, i, squared_radius(rule_, points_.length[i], longest_),
                           list};
    const auto place = points_.at(i);
    tree_.findNeighbors(found, place.data(), nanoflann::SearchParams());
    std::ranges::sort(list);
  }

 private:
  const Points<D>& points_;
  const NeighbourRule& rule_;
  Cloud<D> cloud_;
  Tree<D> tree_;
  double longest_ = 0;
};

}  // namespace

template <int D>
void KdTreeSearch<D>::find(const Points<D>& points, const NeighbourRule& rule,
                           NeighbourLists& lists) {
  if (rule.adjacent > 0) throw std::invalid_argument("only points on a line have adjacent points");
  const Search<D> search(points, rule);
  lists.restart(points.receivers, points.length.size());
#pragma omp parallel if (parallel_from <= points.receivers)
  {
    NeighbourLists::Writer writer(lists);
    std::vector<Index> list;
#pragma omp for schedule(static)
    for (Index i = 0; i < points.receivers; ++i) {
      search.find(i, list);
      writer.close(i, std::ranges::copy(list, writer.room(list.size())).out);
    }
  }
}

template <int D>
std::vector<double> KdTreeSearch<D>::mean_distances(const Points<D>& points, Index count) const {
  const Cloud<D> cloud{points};
  const Tree<D> tree(D, cloud);
  const auto wanted = static_cast<std::size_t>(count) + 1;  // the point itself is the nearest
  std::vector<double> means(points.length.size());
#pragma omp parallel for schedule(static) if (parallel_from <= points.size())
  for (Index i = 0; i < points.size(); ++i) {
    std::vector<Index> nearest(wanted);
    std::vector<double> squared(wanted);
    const auto place = points.at(i);
    const std::size_t found = tree.knnSearch(place.data(), wanted, nearest.data(), squared.data());
    double sum = 0;
    for (std::size_t k = 1; k < found; ++k) sum += std::sqrt(squared[k]);
    means[i] = found > 1 ? sum / static_cast<double>(found - 1) : 0;
  }
  return means;
}

template class KdTreeSearch<1>;
template class KdTreeSearch<2>;
template class KdTreeSearch<3>;

}  // namespace mote
