#include "mote/operators/differential/corrected_sph.hpp"

#include <string>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

template <int D>
Moments<D> moments_of(std::span<const Slope<D>> slopes) {
  Moments<D> sum;
  for (const auto& [x, weight] : slopes) sum.add(x, weight);
  return sum;
}

template <int D>
double second_weight(const Slope<D>& slope, const SecondDerivative<D>& derivative) {
  const auto& x = slope.x;
  return slope.weight *
         (derivative.tensor.dot(products_of<D>(x)) / x.squaredNorm() - x.dot(derivative.offset));
}

}  // namespace

template <int D>
void CorrectedForm<D>::prepare(const Points<D>& points, const NeighbourLists& lists) {
  this->points_ = &points;
  this->lists_ = &lists;
  corrections_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
  for (Index i = 0; i < points.receivers; ++i)
    corrections_[i] = correction_of(moments_of(this->slopes_of(i)));
  for (Index i = 0; i < points.receivers; ++i)
    if (points.needs_weights(i)) refuse_bad_neighbourhood(i);
}

template <int D>
void CorrectedForm<D>::gradient_weights(Index i, std::span<Vec<D>> weights) const {
  const auto slopes = this->slopes_of(i);
  for (std::size_t k = 0; k < slopes.size(); ++k)
    weights[k] = corrections_[i].gradient * (slopes[k].weight * slopes[k].x);
}

template <int D>
void CorrectedForm<D>::laplacian_weights(Index i, std::span<double> weights) const {
  const auto slopes = this->slopes_of(i);
  for (std::size_t k = 0; k < slopes.size(); ++k)
    weights[k] = second_weight(slopes[k], corrections_[i].laplacian);
}

template <int D>
void CorrectedForm<D>::both_weights(Index i, std::span<Vec<D>> gradient,
                                    std::span<double> laplacian) const {
  const auto slopes = this->slopes_of(i);
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    gradient[k] = corrections_[i].gradient * (slopes[k].weight * slopes[k].x);
    laplacian[k] = second_weight(slopes[k], corrections_[i].laplacian);
  }
}

template <int D>
void CorrectedForm<D>::hessian_weights(Index i, std::span<Mat<D>> weights) const {
  const auto slopes = this->slopes_of(i);
  const auto components = hessian_of(moments_of(slopes));
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    int s = 0;
    for (int c = 0; c < D; ++c)
      for (int d = c; d < D; ++d)
        weights[k](c, d) = weights[k](d, c) = second_weight(slopes[k], components[s++]);
  }
}

template <int D>
void CorrectedForm<D>::refuse_bad_neighbourhood(Index i) const {
  if (corrections_[i].exists()) return;
  throw NumericalFailure(
      "particle " + std::to_string(i) + " has " + std::to_string((*this->lists_)[i].size()) +
          " neighbours, and their moment matrix is singular",
      {i}, "they are too few, at the same place, or on too few directions for a parabola");
}

template class CorrectedForm<1>;
template class CorrectedForm<2>;
template class CorrectedForm<3>;

}  // namespace mote
