#include "mote/operators/differential/moment_correction.hpp"

#include <Eigen/LU>
#include <cmath>

namespace mote {
namespace {

/// The matrix of the conditions on a tensor: the sum of its second weights with y.
template <int D>
Eigen::Matrix<double, second_derivatives<D>, second_derivatives<D>> conditions(
    const Moments<D>& moments, const Mat<D>& gradient) {
  return moments.fourth - moments.third.transpose() * gradient * moments.mixed;
}

/// The unit matrix as a tensor.
template <int D>
SymmetricTensor<D> unity() {
  SymmetricTensor<D> unity = SymmetricTensor<D>::Zero();
  for (int d = 0; d < D; ++d) unity += products_of<D>(Vec<D>::Unit(d));
  return unity;
}

}  // namespace

template <int D>
MomentCorrection<D> correction_of(const Moments<D>& moments) {
  // Below this the points lie on fewer directions than there are derivatives to find.
  constexpr double singular = 1e-10;
  auto first = moments.first.fullPivLu();
  first.setThreshold(singular);
  const Mat<D> gradient = first.inverse();
  const auto solver = conditions(moments, gradient).fullPivLu();
  // The conditions are a difference: what is left of it counts against what it was taken from.
  const double least = solver.matrixLU().diagonal().cwiseAbs().minCoeff();
  if (!first.isInvertible() || !(least > singular * moments.fourth.cwiseAbs().maxCoeff()))
    return {Mat<D>::Constant(std::nan("")), {}};
  const SymmetricTensor<D> tensor = solver.solve(2 * unity<D>());
  return {gradient, {tensor, gradient * (moments.mixed * tensor)}};
}

template <int D>
std::array<SecondDerivative<D>, second_derivatives<D>> hessian_of(const Moments<D>& moments) {
  const Mat<D> gradient = moments.first.inverse();
  const auto solver = conditions(moments, gradient).fullPivLu();
  std::array<SecondDerivative<D>, second_derivatives<D>> components;
  int s = 0;
  for (int c = 0; c < D; ++c)
    for (int d = c; d < D; ++d, ++s) {
      // sum_j H_ij x_c x_d is 2 for a diagonal component, and 1 for the others.
      components[s].tensor = solver.solve(SymmetricTensor<D>::Unit(s) * (c == d ? 2 : 1));
      components[s].offset = gradient * (moments.mixed * components[s].tensor);
    }
  return components;
}

template MomentCorrection<1> correction_of(const Moments<1>&);
template MomentCorrection<2> correction_of(const Moments<2>&);
template MomentCorrection<3> correction_of(const Moments<3>&);
template std::array<SecondDerivative<1>, 1> hessian_of(const Moments<1>&);
template std::array<SecondDerivative<2>, 3> hessian_of(const Moments<2>&);
template std::array<SecondDerivative<3>, 6> hessian_of(const Moments<3>&);

}  // namespace mote
