#include "mote/sums/space_expansion.hpp"

#include <omp.h>

#include <array>

namespace mote {
namespace {

/// Nearer nodes would cost more terms than they save pairs of points.
constexpr double largest_ratio = 0.6;

/// How much larger than the sum's the error of the potential of a pair of nodes may be, if the
/// first or the second derivatives of it are wanted: those of hundreds of pairs a level have no
/// common sign, but each derivative of the terms left out is larger by as many times as their
/// degree. Measured, not proved, on smooth fields of lattices, where nothing else is large.
constexpr double pairs_may_err[] = {4, 0.3};

NodeBall ball_of(const TreeNode<3>& node) {
  return {{node.centre[0], node.centre[1], node.centre[2]}, node.radius};
}

}  // namespace

SpaceExpansion::SpaceExpansion(double tolerance, int components, int derivatives)
    : components_(components),
      degrees_(pairs_may_err[derivatives - 1] * tolerance, largest_ratio, highest_degree),
      threads_() {
  threads_.emplace_back(degrees_.degree(), components_);
}

void SpaceExpansion::make_room_for_threads() {
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  while (threads_.size() < threads) threads_.emplace_back(degrees_.degree(), components_);
}

HarmonicExpansion& SpaceExpansion::mine() const {
  return threads_[static_cast<std::size_t>(omp_get_thread_num())];
}

void SpaceExpansion::add_points(const PointTree<3>& tree, Index n,
                                std::span<const double* const> strengths, double* series) const {
  const TreeNode<3>& node = tree.node(n);
  const auto first = static_cast<std::size_t>(node.points.begin);
  PointColumns points{{}, {}, static_cast<std::size_t>(node.points.count())};
  for (std::size_t d = 0; d < 3; ++d) points.position[d] = tree.positions()[d].data() + first;
  std::array<const double*, 3> columns;
  for (std::size_t c = 0; c < strengths.size(); ++c) columns[c] = strengths[c] + first;
  points.strengths = std::span(columns.data(), strengths.size());
  mine().add_points(points, ball_of(node), series);
}

void SpaceExpansion::shift_up(std::span<const Child<3>> children, const TreeNode<3>& parent,
                              double* to) const {
  std::array<ChildMultipole, 8> balls;
  for (std::size_t k = 0; k < children.size(); ++k)
    balls[k] = {children[k].series, ball_of(children[k].node)};
  mine().shift_up(std::span(balls.data(), children.size()), ball_of(parent), to);
}

void SpaceExpansion::translate(std::span<const FarPair<3>> pairs, double target_radius,
                               double* local) const {
  mine().translate(pairs, target_radius, local);
}

void SpaceExpansion::shift_down(const TreeNode<3>& parent, const double* from,
                                std::span<const Child<3>> children) const {
  std::array<ChildLocal, 8> balls;
  for (std::size_t k = 0; k < children.size(); ++k)
    balls[k] = {children[k].series, ball_of(children[k].node)};
  mine().shift_down(from, ball_of(parent), std::span(balls.data(), children.size()));
}

}  // namespace mote
