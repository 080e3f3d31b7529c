#include "mote/sums/space_expansion.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mote {
namespace {

/// What a pair of nodes may err, over what the sum may. That the error of a pair stays below its
/// share is proved for any points; that those of hundreds of pairs at a target add up to less than
/// the whole is measured, as most of them have no common sign. The worst are targets in the middle
/// of shells and of clusters that are alike at all scales.
constexpr double share_of_a_pair = 0.06;

/// Above so many targets the share falls with the root of their number: pairs of large nodes are
/// few and cost little, but their errors are common to many targets.
constexpr double targets_of_a_share = 256;

/// No pair needs to be better than this part of its sources' strength over the distance.
constexpr double rounding = 4e-16;

/// The degree with which balls at half the largest distance keep a tolerance, whatever they hold.
int enough_degrees(double tolerance) {
  return std::min(static_cast<int>(-std::log2(tolerance)), highest_degree);
}

NodeBall ball_of(const TreeNode<3>& node) {
  return {{node.centre[0], node.centre[1], node.centre[2]}, node.radius};
}

}  // namespace

SpaceExpansion::SpaceExpansion(double tolerance, int components)
    : components_(components), tolerance_(tolerance) {
  threads_.emplace_back(enough_degrees(tolerance), components_);
}

void SpaceExpansion::make_room_for_threads() {
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  while (threads_.size() < threads) threads_.emplace_back(degree(), components_);
}

void SpaceExpansion::expect(const FarErrors& largest) {
  for (std::size_t i = 0; i < largest.size(); ++i)
    allowed_[i] = share_of_a_pair * tolerance_ * largest[i];
}

int SpaceExpansion::degree_for(const double* series, const TreeNode<3>& source,
                               const TreeNode<3>& target, double distance) const {
  const PairOfBalls pair{source.radius, target.radius, distance};
  if (are_too_near(pair)) return degree() + 1;
  const double* powers = series + threads_.front().coefficients();
  const double targets = target.points.count();
  const double part = std::sqrt(std::min(1.0, targets_of_a_share / targets));
  double least = rounding * powers[0] / distance;
  FarErrors allowed;
  for (std::size_t i = 0; i < allowed.size(); ++i, least /= distance)
    allowed[i] = std::max(part * allowed_[i], least);
  return TranslationErrors(powers, degree(), pair).lowest_degree(allowed);
}

int SpaceExpansion::degree_within(const double* local, double radius) const {
  FarErrors rest{};
  for (int l = degree(); l > 0; --l) {
    double square = 0;
    for (std::size_t i = harmonic_count(l - 1); i < harmonic_count(l); ++i)
      square += local[i] * local[i];
    double largest = std::sqrt(square);
    for (std::size_t k = 0; k < rest.size(); ++k, largest *= l / radius)
      if ((rest[k] += largest) > allowed_[k]) return l;
  }
  return 0;
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
  SourcePowers(mine(), powers_of(series)).take_points(points, ball_of(node), series);
}

void SpaceExpansion::shift_up(std::span<const Child<3>> children, const TreeNode<3>& parent,
                              double* to) const {
  std::array<ChildMultipole, 8> balls;
  std::array<SourcePowers::Child, 8> powers;
  for (std::size_t k = 0; k < children.size(); ++k) {
    const auto& [node, series] = children[k];
    balls[k] = {series, ball_of(node)};
    powers[k] = {powers_of(series), node.radius, (node.centre - parent.centre).norm()};
  }
  mine().shift_up(std::span(balls.data(), children.size()), ball_of(parent), to);
  SourcePowers(mine(), powers_of(to))
      .take_children(std::span(powers.data(), children.size()), parent.radius, to);
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
