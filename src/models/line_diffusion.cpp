#include "mote/models/line_diffusion.hpp"

#include <algorithm>
#include <cmath>

#include "mote/operators/differential/apply.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// Diagonal coefficient of SDIRK2, 1 - 1/sqrt(2).
const double gamma = 1 - std::sqrt(0.5);

double sum_of_magnitudes(std::span<const double> weights) {
  double sum = 0;
  for (const double weight : weights) sum += std::abs(weight);
  return sum;
}

}  // namespace

void LargestRowSum::take(Index other, double other_sum) {
  if (std::isnan(sum) || other_sum <= sum) return;
  receiver = other;
  sum = other_sum;
}

LargestRowSum largest_row_sum(const DifferentialOperator<1>& op, const NeighbourLists& lists,
                              LineEnds ends) {
  static thread_local std::vector<double> sums;
  sums.resize(static_cast<std::size_t>(lists.receivers()));
  double* const sum = sums.data();
  for_each_row<double>(lists, [&op, sum](Index i, auto, auto weights) {
    op.laplacian_weights(i, weights);
    sum[i] = sum_of_magnitudes(weights);
  });
  if (ends == LineEnds::held) sums.front() = sums.back() = 0;
  LargestRowSum largest;
  for (Index i = 0; i < lists.receivers(); ++i) largest.take(i, sums[i]);
  return largest;
}

void LineDiffusion::assemble(const DifferentialOperator<1>& op, const NeighbourLists& lists,
                             const LineExtension& extension) {
  const Index count = lists.receivers();
  const bool held = extension.ends() == LineEnds::held;
  entries_.clear();
  row_sum_ = {};
  std::vector<double> weights;
  for (Index i = 0; i < count; ++i) {
    entries_.emplace_back(i, i, 0);  // every row has a diagonal, for the 1 of the stages
    if (held && (i == 0 || i == count - 1)) continue;
    const auto neighbours = lists[i];
    weights.resize(neighbours.size());
    op.laplacian_weights(i, weights);
    row_sum_.take(i, sum_of_magnitudes(weights));
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const bool beyond = neighbours[k] >= count;
      const Index j = beyond ? extension.owner(neighbours[k] - count, count) : neighbours[k];
      entries_.emplace_back(i, j, (beyond ? extension.sign(Parity::odd) : 1) * weights[k]);
      entries_.emplace_back(i, i, -weights[k]);
    }
  }
  laplacian_.resize(count, count);
  laplacian_.setFromTriplets(entries_.begin(), entries_.end());
  factorised_amount_.reset();
}

void LineDiffusion::factorise(double amount) {
  if (factorised_amount_ == amount) return;
  Matrix stage = -gamma * amount * laplacian_;
  stage.diagonal().array() += 1;
  solver_.compute(stage);
  if (solver_.info() != Eigen::Success)
    throw NumericalFailure("the equations of the implicit viscosity have no solution", {0},
                           solver_.lastErrorMessage());
  factorised_amount_ = amount;
}

/// With k = L U a stage U = u + sum a k is (1 - gamma amount L)^-1 of what is known before it, and
/// the last stage is the result.
void LineDiffusion::advance_implicitly(double amount, std::span<double> values) {
  factorise(amount);
  Eigen::Map<Vector> u(values.data(), static_cast<Eigen::Index>(values.size()));
  const Vector first = solver_.solve(u);
  const Vector known = u + (1 - gamma) / gamma * (first - u);
  u = solver_.solve(known);
}

std::int64_t LineDiffusion::advance_in_substeps(double amount, std::span<double> values) const {
  const double fewest = std::ceil(amount * row_sum_.sum);
  if (std::isnan(fewest))
    throw NumericalFailure("the Laplacian's weights are no longer numbers", {row_sum_.receiver},
                           "the state is not finite any more");
  if (fewest > 1e6)
    throw NumericalFailure(
        "the viscosity needs more than a million sub-steps in half a step", {row_sum_.receiver},
        "the neighbours there are very close for this viscosity and step; the implicit scheme has "
        "no limit");
  const auto substeps = std::max<std::int64_t>(1, static_cast<std::int64_t>(fewest));
  const double part = amount / static_cast<double>(substeps);
  Eigen::Map<Vector> u(values.data(), static_cast<Eigen::Index>(values.size()));
  for (std::int64_t k = 0; k < substeps; ++k) {
    const Vector rate = laplacian_ * u;
    const Vector ahead = u + part * rate;
    u += 0.5 * part * (rate + laplacian_ * ahead);
  }
  return substeps;
}

}  // namespace mote
