#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "mote/exact/cole_hopf.hpp"
#include "mote/exact/exact_solution.hpp"

namespace mote {

/// Gas at the start: its fields on the whole line, and the particles that are followed.
struct BurgersStart {
  std::function<double(double)> velocity;  ///< bounded; smooth but for kinks and jumps
  std::function<double(double)> density;
  std::vector<double> particles;  ///< their positions
  double lower = 0, upper = 1;  ///< where the particles are; starts vary over 1/1000 of it or more
  double viscosity = 0;         ///< kinematic, > 0
};

/// Viscous pressureless gas without gravity (Isshiki 2014, (81) and (88)):
///   u_t + u u_x = nu u_xx,   rho_t + (rho u)_x = 0   on the whole line.
/// The velocity is that of Cole (1951) and Hopf (1950), see ColeHopf; a particle that starts at a
/// follows it, see cole_hopf_paths.hpp, and the gas around it has the density rho0(a)/J. Velocities
/// at places are good to 1e-15 of the largest and positions of particles to some 1e-13 of the
/// domain, which in a layer of slope u_x moves their velocity by u_x times as much; densities to
/// some 1e-12, at places times the compression.
///
/// Where gas is compressed by more than 1e308, as in a thin layer late, the density is infinite.
/// One object is for one thread: it learns more of the start as later times are asked for.
class BurgersColeHopf final : public ExactSolution {
 public:
  static constexpr std::string_view name = "burgers_cole_hopf";
  static constexpr std::string_view summary =
      "viscous pressureless gas without gravity on the whole line, that is Burgers' equation";

  /// Throws std::invalid_argument for a viscosity that is not positive, no particles, or a start
  /// that grows towards infinity, is not piecewise smooth or somewhere no number.
  explicit BurgersColeHopf(BurgersStart start);

  std::string statement() const override;
  /// Until waves come from farther away than 4000 times the length of the domain.
  double valid_until() const override;

  /// Position, velocity, density. Throws std::domain_error if the waves come from farther away than
  /// 4000 times the length of the domain, as in the others.
  Table of_particles(double time) const override;
  /// Velocity and density; for the density the place is followed back to its start. In a layer that
  /// compressed the gas more than 1e10 times a place is no longer known well enough for that, and
  /// the density is NaN.
  Table at_places(std::span<const double> position, double time) const override;
  /// Of particles that start at equal distances, and of more where the profile is steep.
  Table curve(double time) const override;

 private:
  void cover(std::span<const double> places, double time) const;
  Table table_of(std::span<const double> labels, double time) const;

  BurgersStart start_;
  mutable ColeHopf motion_;  ///< grows with the time asked for
};

}  // namespace mote
