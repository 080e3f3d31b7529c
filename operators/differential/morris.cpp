#include "mote/operators/differential/morris.hpp"

#include <cmath>
#include <string>

#include "mote/particles/failure.hpp"

namespace mote {

template <int D>
void MorrisForm<D>::prepare(const Points<D>& points, const NeighbourLists& lists) {
  this->points_ = &points;
  this->lists_ = &lists;
  scale_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
  for (Index i = 0; i < points.receivers; ++i) {
    double sum = 0;
    for (const auto& [x, weight] : this->slopes_of(i)) sum += weight * x.squaredNorm();
    scale_[i] = D / sum;
  }
  for (Index i = 0; i < points.receivers; ++i)
    if (points.needs_weights(i)) refuse_bad_neighbourhood(i);
}

template <int D>
void MorrisForm<D>::gradient_weights(Index i, std::span<Vec<D>> weights) const {
  const auto slopes = this->slopes_of(i);
  for (std::size_t k = 0; k < slopes.size(); ++k)
    weights[k] = scale_[i] * slopes[k].weight * slopes[k].x;
}

template <int D>
void MorrisForm<D>::laplacian_weights(Index i, std::span<double> weights) const {
  const auto slopes = this->slopes_of(i);
  for (std::size_t k = 0; k < slopes.size(); ++k) weights[k] = 2 * scale_[i] * slopes[k].weight;
}

template <int D>
void MorrisForm<D>::hessian_weights(Index i, std::span<Mat<D>> weights) const {
  const auto slopes = this->slopes_of(i);
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    const Vec<D> e = slopes[k].x.normalized();
    weights[k] = scale_[i] * slopes[k].weight * ((D + 2) * e * e.transpose() - Mat<D>::Identity());
  }
}

template <int D>
void MorrisForm<D>::refuse_bad_neighbourhood(Index i) const {
  if (std::isfinite(scale_[i])) return;
  throw NumericalFailure(
      "particle " + std::to_string(i) + " has " + std::to_string((*this->lists_)[i].size()) +
          " neighbours, and the second moment of their weights is 0 or not finite",
      {i}, "no other point lies within the support, or one is at the same place");
}

template class MorrisForm<1>;
template class MorrisForm<2>;
template class MorrisForm<3>;

}  // namespace mote
