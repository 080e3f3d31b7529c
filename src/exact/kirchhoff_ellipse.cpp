#include "mote/exact/kirchhoff_ellipse.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>

namespace mote {
namespace {

using Complex = std::complex<double>;

/// u + i v at z in axes along those of the ellipse.
Complex velocity_at(const VortexEllipse& ellipse, Complex z) {
  const double a = ellipse.long_axis, b = ellipse.short_axis, omega = ellipse.vorticity;
  const double x = z.real() / a, y = z.imag() / b;
  if (x * x + y * y <= 1) return omega / (a + b) * Complex(-a * z.imag(), b * z.real());
  const double c = std::sqrt(a * a - b * b);
  const Complex root = std::sqrt(z - c) * std::sqrt(z + c);  // ~ z far away, cut between the foci
  return std::conj(Complex(0, -omega * a * b) / (z + root));
}

}  // namespace

double KirchhoffEllipse::turning_rate() const {
  const double a = ellipse_.long_axis, b = ellipse_.short_axis;
  return ellipse_.vorticity * a * b / ((a + b) * (a + b));
}

std::string KirchhoffEllipse::statement() const {
  return fmt::format(
      "kirchhoff_ellipse is exact for an ellipse of half axes {:.6g} and {:.6g} and vorticity "
      "{:.6g} without friction, which turns at the rate {:.6g}",
      ellipse_.long_axis, ellipse_.short_axis, ellipse_.vorticity, turning_rate());
}

Table KirchhoffEllipse::at_places(std::span<const double> position, int dimension,
                                  double time) const {
  const Complex turn = std::polar(1.0, ellipse_.angle + turning_rate() * time);
  const Complex centre(ellipse_.centre[0], ellipse_.centre[1]);
  return flow_table(position, dimension, WithPressure::no, [&](const auto& place) -> FlowState {
    const Complex z = (Complex(place[0], place[1]) - centre) / turn;
    const Complex velocity = velocity_at(ellipse_, z) * turn;
    return {{velocity.real(), velocity.imag()}};
  });
}

}  // namespace mote
