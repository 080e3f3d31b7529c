#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace mote::test {

/// Two thin coaxial rings of the same circulation 1, by their radii and places on the axis: each
/// goes with its own speed, (ln(8 R/a) - 0.558)/(4 pi R) for a Gauss function as core, whose volume
/// a^2 R stays, and with the velocity of the other's circle (Dyson 1893; Hicks 1922).
class ThinRings {
 public:
  struct State {
    double outer = 1, outer_z = 0, inner = 1, inner_z = 0;  ///< the names are those of the start
  };

  ThinRings(const State& start, double core)
      : state_{start.outer, start.outer_z, start.inner, start.inner_z},
        volumes_{core * core * start.outer, core * core * start.inner} {}

  State state() const { return {state_[0], state_[1], state_[2], state_[3]}; }

  /// By the classical Runge-Kutta method.
  void advance(double step) {
    const Rates a = rates(state_), b = rates(moved(a, step / 2));
    const Rates c = rates(moved(b, step / 2)), d = rates(moved(c, step));
    for (std::size_t k = 0; k < 4; ++k) state_[k] += step / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  }

 private:
  using Rates = std::array<double, 4>;

  Rates moved(const Rates& rate, double step) const {
    Rates result = state_;
    for (std::size_t k = 0; k < 4; ++k) result[k] += step * rate[k];
    return result;
  }

  Rates rates(const Rates& state) const {
    Rates result{};
    for (std::size_t k : {0u, 1u}) {
      const double radius = state[2 * k], z = state[2 * k + 1];
      const double other = state[2 - 2 * k], other_z = state[3 - 2 * k];
      const auto velocity = of_circle(other, radius, z - other_z);
      const double core = std::sqrt(volumes_[k] / radius);
      result[2 * k] = velocity[0];
      result[2 * k + 1] =
          velocity[1] + (std::log(8 * radius / core) - 0.558) / (4 * std::numbers::pi * radius);
    }
    return result;
  }

  /// The velocity outwards and along the axis at the distance r from it, z above the plane of a
  /// circle of this radius (Lamb 1932, 161): with A = z^2 + (r + R)^2 and k^2 = 4 r R/A,
  ///   u_z = (K + E (R^2 - r^2 - z^2)/B)/(2 pi sqrt(A)),   B = z^2 + (R - r)^2,
  ///   u_r = z/r (E (R^2 + r^2 + z^2)/B - K)/(2 pi sqrt(A)).
  static std::array<double, 2> of_circle(double radius, double r, double z) {
    const double far = z * z + std::pow(r + radius, 2), near = z * z + std::pow(radius - r, 2);
    const double modulus = std::sqrt(4 * r * radius / far);
    const double first = std::comp_ellint_1(modulus), second = std::comp_ellint_2(modulus);
    const double scale = 1 / (2 * std::numbers::pi * std::sqrt(far));
    const double squares = radius * radius - r * r - z * z, sum = radius * radius + r * r + z * z;
    return {scale * z / r * (second * sum / near - first),
            scale * (first + second * squares / near)};
  }

  Rates state_;
  std::array<double, 2> volumes_;
};

}  // namespace mote::test
