#pragma once

#include <Eigen/Core>

namespace mote {

/// Places and weights of a quadrature.
struct GaussRule {
  Eigen::VectorXd place, weight;
};

/// integral of f over [0, 1], exact for polynomials of degree 2 count - 1 (Golub & Welsch 1969).
GaussRule gauss_legendre(int count);

/// integral of f(x) e^-x over [0, infinity), exact for polynomials of degree 2 count - 1.
GaussRule gauss_laguerre(int count);

}  // namespace mote
