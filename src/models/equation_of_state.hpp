#pragma once

#include <cmath>

namespace mote {

/// p = B ((rho/rho0)^gamma - 1) + p0 with B = rho0 c^2/gamma (Tait; Cole 1948, Monaghan 1994);
/// gamma = 1 is the linear p = c^2 (rho - rho0) + p0.
struct EquationOfState {
  double density = 1;      ///< rho0
  double sound_speed = 1;  ///< c at rho0
  double exponent = 1;     ///< gamma
  double background = 0;   ///< p0

  double stiffness() const { return density * sound_speed * sound_speed / exponent; }

  double pressure(double rho) const {
    if (exponent == 1) return sound_speed * sound_speed * (rho - density) + background;
    const double s = rho / density;
    const double power = exponent == 7 ? sixth_power(s) * s : std::pow(s, exponent);
    return stiffness() * (power - 1) + background;
  }

  /// The density that has this pressure; not a number for tensions that no density has.
  double density_at(double pressure) const {
    if (exponent == 1) return density + (pressure - background) / (sound_speed * sound_speed);
    return density * std::pow((pressure - background) / stiffness() + 1, 1 / exponent);
  }

  /// Energy of compression a mass, the integral of p/rho^2 from rho0, without p0's part.
  double energy(double rho) const {
    const double s = rho / density, c2 = sound_speed * sound_speed;
    if (exponent == 1) return c2 * (std::log(s) + 1 / s - 1);
    const double power = exponent == 7 ? sixth_power(s) : std::pow(s, exponent - 1);
    return c2 / exponent * ((power - 1) / (exponent - 1) + 1 / s - 1);
  }

 private:
  static double sixth_power(double s) {
    const double s2 = s * s;
    return s2 * s2 * s2;
  }
};

}  // namespace mote
