#include "mote/study/check_up.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numbers>

#include "mote/operators/differential/monomials.hpp"

namespace mote {
namespace {

template <int D>
double volume(double length) {
  return std::pow(length, D);
}

/// Volume of the ball of radius 1.
template <int D>
constexpr double unit_ball = D == 1   ? 2
                             : D == 2 ? std::numbers::pi
                                      : 4 * std::numbers::pi / 3;

template <int D>
double covered_share(const Points<D>& points, const NeighbourRule& rule,
                     std::span<const Index> list, Index i) {
  if (rule.adjacent > 0) return std::numeric_limits<double>::quiet_NaN();
  double sum = volume<D>(points.length[i]);
  for (const Index j : list) sum += volume<D>(points.length[j]);
  return sum / (unit_ball<D> * volume<D>(rule.reach() * points.length[i]));
}

/// From the eigenvalues of the normal equations of the monomials of degree 1 and 2, which are the
/// squares of the singular values.
template <int D>
double condition_number(const Points<D>& points, std::span<const Index> list, Index i) {
  constexpr int unknowns = D + second_derivatives<D>;
  using Square = Eigen::Matrix<double, unknowns, unknowns>;
  Square normal = Square::Zero();
  for (const Index j : list) {
    const Vec<D> x = (points.at(j) - points.at(i)) / points.length[i];
    Eigen::Matrix<double, unknowns, 1> row;
    row << x, products_of<D>(x);
    normal += row * row.transpose();
  }
  const auto lengths = normal.diagonal().cwiseSqrt().eval();
  for (int a = 0; a < unknowns; ++a)
    for (int b = 0; b < unknowns; ++b)
      if (lengths[a] * lengths[b] > 0) normal(a, b) /= lengths[a] * lengths[b];
  const auto values =
      Eigen::SelfAdjointEigenSolver<Square>(normal, Eigen::EigenvaluesOnly).eigenvalues();
  constexpr double rounding = 1e-13;  // of an eigenvalue, so that 3e6 is the largest condition
  const bool fixed = list.size() >= unknowns && values[0] > rounding * values[unknowns - 1];
  return fixed ? std::sqrt(values[unknowns - 1] / values[0])
               : std::numeric_limits<double>::infinity();
}

}  // namespace

CheckUpSummary summary_of(const std::vector<Neighbourhood>& neighbourhoods) {
  constexpr double most = std::numeric_limits<double>::infinity();
  CheckUpSummary summary{.fewest = {most}, .least_covered = {most}};
  for (std::size_t k = 0; k < neighbourhoods.size(); ++k) {
    const auto& [neighbours, covered, condition] = neighbourhoods[k];
    const auto point = static_cast<Index>(k);
    if (neighbours < summary.fewest.value) summary.fewest = {double(neighbours), point};
    if (covered < summary.least_covered.value) summary.least_covered = {covered, point};
    if (!std::isfinite(condition))
      ++summary.without_parabola;
    else if (condition > summary.worst_condition.value)
      summary.worst_condition = {condition, point};
  }
  return summary;
}

template <int D>
std::vector<Neighbourhood> check_up(const Points<D>& points, const NeighbourRule& rule,
                                    const NeighbourLists& lists) {
  std::vector<Neighbourhood> result(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
  for (Index i = 0; i < points.receivers; ++i)
    result[i] = {static_cast<Index>(lists[i].size()), covered_share(points, rule, lists[i], i),
                 condition_number(points, lists[i], i)};
  return result;
}

template std::vector<Neighbourhood> check_up(const Points<1>&, const NeighbourRule&,
                                             const NeighbourLists&);
template std::vector<Neighbourhood> check_up(const Points<2>&, const NeighbourRule&,
                                             const NeighbourLists&);
template std::vector<Neighbourhood> check_up(const Points<3>&, const NeighbourRule&,
                                             const NeighbourLists&);

}  // namespace mote
