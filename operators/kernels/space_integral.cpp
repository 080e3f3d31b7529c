#include "mote/operators/kernels/space_integral.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace mote {

double line_integral(const std::function<double(double)>& f, double lower, double upper) {
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, lower, upper, 15, 1e-15);
}

}  // namespace mote
