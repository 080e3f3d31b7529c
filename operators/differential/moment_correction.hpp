#pragma once

#include <array>

#include "mote/operators/differential/monomials.hpp"

namespace mote {

/// A symmetric tensor A as xx, 2 xy, 2 xz, yy, 2 yz, zz: e^T A e is its product with the products
/// of e's components.
template <int D>
using SymmetricTensor = Eigen::Matrix<double, second_derivatives<D>, 1>;

/// Sums over the neighbours of a receiver, of weight F at x = x_j - x_i; y stands for the products
/// x_c x_d and r for the length of x.
template <int D>
struct Moments {
  static constexpr int second = second_derivatives<D>;

  Mat<D> first = Mat<D>::Zero();                                 ///< sum F x x^T
  Eigen::Matrix<double, D, second> mixed = mixed.Zero();         ///< sum F/r^2 x y^T
  Eigen::Matrix<double, D, second> third = third.Zero();         ///< sum F x y^T
  Eigen::Matrix<double, second, second> fourth = fourth.Zero();  ///< sum F/r^2 y y^T

  void add(const Vec<D>& x, double weight) {
    const SymmetricTensor<D> y = products_of<D>(x);
    const Vec<D> weighted = weight * x;
    const double over_square = 1 / x.squaredNorm();
    first += weighted * x.transpose();
    third += weighted * y.transpose();
    mixed += (over_square * weighted) * y.transpose();
    fourth += (over_square * weight * y) * y.transpose();
  }
};

/// A second derivative by the weights F (e^T A e - x . offset).
template <int D>
struct SecondDerivative {
  SymmetricTensor<D> tensor;
  Vec<D> offset;
};

/// What makes weighted differences exact for linear fields, and those of second derivatives for
/// parabolas (Fatehi & Manzari 2011).
template <int D>
struct MomentCorrection {
  Mat<D> gradient;  ///< B; NaN where the neighbours fix no parabola
  SecondDerivative<D> laplacian;

  bool exists() const { return gradient.allFinite(); }
};

template <int D>
MomentCorrection<D> correction_of(const Moments<D>& moments);

/// The components xx, xy, xz, yy, yz, zz of the Hessian. The correction must exist.
template <int D>
std::array<SecondDerivative<D>, second_derivatives<D>> hessian_of(const Moments<D>& moments);

extern template MomentCorrection<1> correction_of(const Moments<1>&);
extern template MomentCorrection<2> correction_of(const Moments<2>&);
extern template MomentCorrection<3> correction_of(const Moments<3>&);
extern template std::array<SecondDerivative<1>, 1> hessian_of(const Moments<1>&);
extern template std::array<SecondDerivative<2>, 3> hessian_of(const Moments<2>&);
extern template std::array<SecondDerivative<3>, 6> hessian_of(const Moments<3>&);

}  // namespace mote
