#include "mote/exact/rotating_square_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace mote {

double rotating_square_patch_pressure(double x, double y) {
  using std::numbers::pi;
  double from_x = std::min(x, 1 - x), from_y = std::min(y, 1 - y);
  if (!(from_x >= 0 && from_y >= 0)) return std::numeric_limits<double>::quiet_NaN();
  if (from_x == 0 || from_y == 0) return 0;
  if (from_x > from_y) std::swap(from_x, from_y);
  double pressure = -from_x * (1 - from_x);
  for (int n = 1;; n += 2) {
    const double wave = n * pi;
    // cosh(wave (y - 1/2))/cosh(wave/2) without overflow.
    const double profile =
        (std::exp(-wave * from_y) + std::exp(-wave * (1 - from_y))) / (1 + std::exp(-wave));
    const double size = 8 * profile / (wave * wave * wave);
    if (size < 1e-17) return pressure;
    pressure += size * std::sin(wave * from_x);
  }
}

}  // namespace mote
