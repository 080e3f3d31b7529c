#pragma once

#include "mote/xivas/matrix_exponentials.hpp"

namespace mote {

/// How the coefficients of R are evaluated.
enum class SpectralScheme {
  piecewise,  ///< by the piecewise divided differences: (57), (46) and section 6
  usual,      ///< by (190), or from first differences: what rounding spoils near equal eigenvalues
};

/// P, Q and R by eigenvalues and divided differences: Nadukandi 2014. R by (57) or (46), from it
/// Q = R A + t I and P = Q A + I. For comparisons: loses every digit for eigenvalues near -50,
/// where `matrix_exponentials` does not. D is 2 or 3, t not negative; the usual scheme divides by
/// zero for equal eigenvalues, and needs D = 3.
template <int D>
MatrixExponentials<double, D> spectral_exponentials(const Eigen::Matrix<double, D, D>& a, double t,
                                                    SpectralScheme scheme);

}  // namespace mote
