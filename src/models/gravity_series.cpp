#include "mote/models/gravity_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mote {
namespace {

using Eigen::Index;

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;
template <int D>
using Square = Eigen::Matrix<double, D, D>;

/// The series of a^power, y = a^power, from a y' = power a' y:
///   k a_0 y_k = sum over j = 1 ... k of (power j - (k - j)) a_j y_(k-j).
std::vector<double> power_of(const std::vector<double>& a, double power) {
  std::vector<double> y(a.size());
  y[0] = std::pow(a[0], power);
  for (std::size_t k = 1; k < a.size(); ++k) {
    double sum = 0;
    for (std::size_t j = 1; j <= k; ++j)
      sum += (power * static_cast<double>(j) - static_cast<double>(k - j)) * a[j] * y[k - j];
    y[k] = sum / (static_cast<double>(k) * a[0]);
  }
  return y;
}

/// The series of a pair: d, |d|^-D, and the derivative of d |d|^-D by d.
template <int D>
struct PairSeries {
  std::vector<Vector<D>> separation;
  std::vector<double> square, inverse;

  PairSeries(std::span<const Eigen::VectorXd> path, Index i, Index j, std::size_t count)
      : separation(count, Vector<D>::Zero()), square(count) {
    for (std::size_t k = 0; k < std::min(count, path.size()); ++k)
      separation[k] = path[k].template segment<D>(i * D) - path[k].template segment<D>(j * D);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t l = 0; l <= k; ++l) square[k] += separation[l].dot(separation[k - l]);
    inverse = power_of(square, -0.5 * D);
  }

  Vector<D> pull(std::size_t k) const {
    Vector<D> sum = Vector<D>::Zero();
    for (std::size_t l = 0; l <= k; ++l) sum += inverse[l] * separation[k - l];
    return sum;
  }

  /// |d|^-D I - D |d|^-(D+2) d d^T, the first so many coefficients.
  std::vector<Square<D>> derivative(std::size_t count) const {
    const std::vector<double> steeper = power_of(square, -0.5 * D - 1);
    std::vector<Square<D>> result(count, Square<D>::Zero());
    for (std::size_t k = 0; k < count; ++k) {
      result[k] = inverse[k] * Square<D>::Identity();
      for (std::size_t l = 0; l <= k; ++l)
        for (std::size_t m = 0; l + m <= k; ++m)
          result[k] -= D * steeper[k - l - m] * separation[l] * separation[m].transpose();
    }
    return result;
  }
};

/// Two bodies, and what one of them does to the other by its mass, G m.
struct Pair {
  Index first, second;
  double pull_of_first, pull_of_second;
};

template <int D>
void add_forces(const Pair& pair, const PairSeries<D>& series, std::span<Eigen::VectorXd> force) {
  for (std::size_t k = 0; k < force.size(); ++k) {
    const Vector<D> pull = series.pull(k);
    force[k].segment<D>(pair.first * D) -= pair.pull_of_second * pull;
    force[k].segment<D>(pair.second * D) += pair.pull_of_first * pull;
  }
}

template <int D>
void add_derivatives(const Pair& pair, const PairSeries<D>& series,
                     std::span<Eigen::MatrixXd> derivative) {
  const auto slopes = series.derivative(derivative.size());
  for (std::size_t k = 0; k < derivative.size(); ++k) {
    const auto block = [&](Index a, Index b) { return derivative[k].block<D, D>(a * D, b * D); };
    block(pair.first, pair.first) -= pair.pull_of_second * slopes[k];
    block(pair.first, pair.second) += pair.pull_of_second * slopes[k];
    block(pair.second, pair.second) -= pair.pull_of_first * slopes[k];
    block(pair.second, pair.first) += pair.pull_of_first * slopes[k];
  }
}

}  // namespace

template <int D>
void GravitySeries<D>::expand(std::span<const Eigen::VectorXd> path,
                              std::span<Eigen::VectorXd> force,
                              std::span<Eigen::MatrixXd> derivative) {
  ++expansions_;
  const auto bodies = static_cast<Index>(mass_.size());
  for (auto& coefficient : force) coefficient = Eigen::VectorXd::Zero(bodies * D);
  for (auto& coefficient : derivative) coefficient = Eigen::MatrixXd::Zero(bodies * D, bodies * D);
  const auto pull_of = [&](Index body) {
    return gravitational_constant_ * mass_[static_cast<std::size_t>(body)];
  };
  for (Index i = 0; i < bodies; ++i)
    for (Index j = 0; j < i; ++j) {
      const Pair pair{i, j, pull_of(i), pull_of(j)};
      const PairSeries<D> series(path, i, j, std::max(force.size(), derivative.size()));
      add_forces(pair, series, force);
      add_derivatives(pair, series, derivative);
    }
}

template <int D>
Eigen::VectorXd GravitySeries<D>::weights() const {
  double total = 0;
  for (const double mass : mass_) total += mass;
  constexpr double eps = std::numeric_limits<double>::epsilon();
  Eigen::VectorXd result(static_cast<Index>(mass_.size()) * D);
  for (Index i = 0; i < result.size(); ++i)
    result[i] = total > 0 ? mass_[static_cast<std::size_t>(i / D)] + eps * eps * total : 1;
  return result;
}

template class GravitySeries<2>;
template class GravitySeries<3>;

}  // namespace mote
