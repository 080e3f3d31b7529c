#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/operators/weights/lattice_sum.hpp"
#include "mote/operators/weights/reciprocal.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// Which number density n and mean square distance lambda divide the weights of MPS.
enum class MpsConstants { local, lattice };

/// The moving particle semi-implicit method (Isshiki 2014, (70), (71), in D dimensions after
/// Koshizuka & Oka 1996):
///   g_ij = (D/n_i) w_ij (x_j - x_i)/r_ij^2,   l_ij = 2 D/(lambda_i n_i) w_ij,
///   n_i = sum_j w_ij,   lambda_i = sum_j r_ij^2 w_ij / n_i.
/// The paper has no Hessian for it. The one whose trace is (70b) is that of Espanol & Revenga
/// (2003):
///   H_ij = D/(lambda_i n_i) w_ij [(D+2) e_ij e_ij^T - 1].
template <int D>
class Mps final : public DifferentialOperator<D> {
 public:
  static constexpr int highest_dimension = 3;
  static constexpr std::string_view family = "mps";
  static constexpr std::string_view summary = "moving particle semi-implicit, (70) and (71)";
  using Weight = Reciprocal;

  double smoothing_length = Weight::usual_length;  ///< in local spacings
  PairLength length = PairLength::mean;
  MpsConstants constants = MpsConstants::local;

  void describe(Description& description) override {
    static constexpr Word<MpsConstants> choices[] = {
        {MpsConstants::local, "local", "each particle's own, as in (70) and (71)"},
        {MpsConstants::lattice, "lattice",
         "those of a lattice, n0 and lambda0, which makes the Laplacian symmetric"}};
    describe_lengths(description, smoothing_length, length);
    describe_words(description, {"constants", "which n and lambda weights are divided by"},
                   constants, choices);
  }

  bool has_symmetric_laplacian() const override { return constants == MpsConstants::lattice; }

  NeighbourRule neighbour_rule() const override {
    return {Weight::support, smoothing_length, length};
  }

  void prepare(const Points<D>& points, const NeighbourLists& lists) override {
    points_ = &points;
    lists_ = &lists;
    number_density_.resize(static_cast<std::size_t>(points.receivers));
    lambda_.resize(static_cast<std::size_t>(points.receivers));
    if (constants == MpsConstants::local)
      take_local_constants();
    else
      take_lattice_constants();
  }

  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Index j = list[k];
      weights[k] = D / number_density_[i] * weight(i, j) / squared_distance(i, j) *
                   (points_->at(j) - points_->at(i));
    }
  }

  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Vec<D> e = (points_->at(list[k]) - points_->at(i)).normalized();
      weights[k] = D / (lambda_[i] * number_density_[i]) * weight(i, list[k]) *
                   ((D + 2) * e * e.transpose() - Mat<D>::Identity());
    }
  }

  void laplacian_weights(Index i, std::span<double> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k)
      weights[k] = 2 * D / (lambda_[i] * number_density_[i]) * weight(i, list[k]);
  }

  void both_weights(Index i, std::span<Vec<D>> gradient,
                    std::span<double> laplacian) const override {
    const auto list = (*lists_)[i];
    const double factor = D / number_density_[i],
                 second = 2 * D / (lambda_[i] * number_density_[i]);
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Vec<D> x = points_->at(list[k]) - points_->at(i);
      const double w = weight(i, list[k]);
      gradient[k] = factor * w / x.squaredNorm() * x;
      laplacian[k] = second * w;
    }
  }

  /// lambda of a lattice, in squared spacings.
  double lattice_lambda() const {
    const double moment = lattice_sum<D>(smoothing_length, [this](double distance) {
      return distance * distance * Weight::value(distance / smoothing_length);
    });
    return moment / lattice_density();
  }

 private:
  void take_local_constants() {
#pragma omp parallel for schedule(static) if (parallel_from <= points_->receivers)
    for (Index i = 0; i < points_->receivers; ++i) {
      double n = 0, moment = 0;
      for (const Index j : (*lists_)[i]) {
        const double w = weight(i, j);
        n += w;
        moment += w * squared_distance(i, j);
      }
      number_density_[i] = n;
      lambda_[i] = moment / n;
    }
    refuse_bad_neighbourhoods();
  }

  /// n0 and lambda0 of a lattice with each receiver's spacing (Koshizuka & Oka 1996).
  void take_lattice_constants() {
    const double n0 = lattice_density(), lambda0 = lattice_lambda();
#pragma omp parallel for schedule(static) if (parallel_from <= points_->receivers)
    for (Index i = 0; i < points_->receivers; ++i) {
      number_density_[i] = weight_of_nearest(i);
      lambda_[i] = lambda0 * points_->length[i] * points_->length[i];
    }
    refuse_bad_neighbourhoods();
    std::ranges::fill(number_density_, n0);
  }
  double weight_of_nearest(Index i) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Index j : (*lists_)[i]) {
      const double h = pair_length(length, points_->length[i], points_->length[j]);
      nearest = std::min(nearest, squared_distance(i, j) / (h * h));
    }
    return Weight::value(std::sqrt(nearest) / smoothing_length);
  }
  double lattice_density() const {
    return lattice_sum<D>(smoothing_length, [this](double distance) {
      return Weight::value(distance / smoothing_length);
    });
  }

  double squared_distance(Index i, Index j) const {
    return (points_->at(i) - points_->at(j)).squaredNorm();
  }
  double weight(Index i, Index j) const {
    const double h = smoothing_length * pair_length(length, points_->length[i], points_->length[j]);
    return Weight::value(std::sqrt(squared_distance(i, j)) / h);
  }

  void refuse_bad_neighbourhoods() const {
    for (Index i = 0; i < points_->receivers; ++i) {
      // A neighbour on the rim has the weight 0, or what rounding makes of it: that is none.
      constexpr double rounding = 1e-9;
      if (!points_->needs_weights(i)) continue;
      if (number_density_[i] > rounding && std::isfinite(lambda_[i])) continue;
      const bool coincident = !std::isfinite(number_density_[i]);
      const std::string what = coincident ? " coincides with another" : " has no neighbour";
      throw NumericalFailure("particle " + std::to_string(i) + what, {i},
                             coincident ? "the MPS weight h/r - 1 has no value at r = 0"
                                        : "no other point lies within the smoothing length");
    }
  }

  const Points<D>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;
  std::vector<double> number_density_, lambda_;
};

}  // namespace mote
