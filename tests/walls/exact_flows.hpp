#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "mote/walls/panel_bodies.hpp"

namespace mote::test {

inline constexpr double pi = std::numbers::pi;

/// Largest difference.
inline double error(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

/// Slope of the logarithm of the error from one number of panels to twice as many.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

/// Sheets on one body in a stream (1, 0), with vortices and a circulation of the sheet.
inline std::vector<double> sheet_in_stream(const PanelBodies& bodies, double circulation,
                                           const Vortices& vortices = {}) {
  const std::vector<double> required{circulation};
  return bodies.sheet(bodies.circulation_along_panels(1, vortices), required);
}

inline std::vector<Complex> square(double half_side, Complex turn = 1) {
  return {turn * Complex(half_side, -half_side), turn * Complex(half_side, half_side),
          turn * Complex(-half_side, half_side), turn * Complex(-half_side, -half_side)};
}

}  // namespace mote::test
