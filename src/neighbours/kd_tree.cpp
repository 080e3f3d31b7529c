#include "mote/neighbours/kd_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <stdexcept>

namespace mote {
namespace {

/// Receivers whose lists one thread finds together. A fixed number, so that the pieces do not
/// depend on the threads.
constexpr Index block_size = 256;

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

  /// Appends the neighbours of receiver i to a list; returns their number.
  std::int64_t append(Index i, std::vector<Index>& list) const {
    const auto before = static_cast<std::ptrdiff_t>(list.size());
    Neighbourhood<D> found{points_, rule_, i, squared_radius(rule_, points_.length[i], longest_),
                           list};
    const auto place = points_.at(i);
    tree_.findNeighbors(found, place.data(), nanoflann::SearchParams());
    std::sort(list.begin() + before, list.end());
    return static_cast<std::int64_t>(list.size()) - before;
  }

 private:
  const Points<D>& points_;
  const NeighbourRule& rule_;
  Cloud<D> cloud_;
  Tree<D> tree_;
  double longest_ = 0;
};

/// Makes room for so many neighbours, with some to spare: moving points may meet more.
void resize(std::vector<Index>& neighbour, std::size_t pairs) {
  if (neighbour.capacity() < pairs) neighbour.reserve(pairs + pairs / 4);
  neighbour.resize(pairs);
}

}  // namespace

template <int D>
void KdTreeSearch<D>::find(const Points<D>& points, const NeighbourRule& rule,
                           NeighbourLists& lists) const {
  if (rule.adjacent > 0) throw std::invalid_argument("only points on a line have adjacent points");
  const Index receivers = points.receivers;
  const Index blocks = (receivers + block_size - 1) / block_size;
  const Search<D> search(points, rule);
  std::vector<std::vector<Index>> found(static_cast<std::size_t>(blocks));
  auto& start = lists.start;
  start.assign(static_cast<std::size_t>(receivers) + 1, 0);
#pragma omp parallel for schedule(static) if (parallel_from <= receivers)
  for (Index block = 0; block < blocks; ++block) {
    const Index end = std::min(receivers, (block + 1) * block_size);
    for (Index i = block * block_size; i < end; ++i) start[i + 1] = search.append(i, found[block]);
  }
  for (Index i = 0; i < receivers; ++i) start[i + 1] += start[i];
  resize(lists.neighbour, static_cast<std::size_t>(start.back()));
#pragma omp parallel for schedule(static) if (parallel_from <= receivers)
  for (Index block = 0; block < blocks; ++block)
    std::ranges::copy(found[block], lists.neighbour.begin() + start[block * block_size]);
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
