#pragma once

#include <string>
#include <string_view>

#include "mote/integrators/integrator.hpp"

namespace mote {

/// X-IVAS, explicit integration of velocity and acceleration along the streamlines: Nadukandi 2014,
/// section 3. Velocities and accelerations of the particles are frozen for the step as fields on a
/// background mesh, `ParticleFields`; places go along the streamlines of the velocity, velocities
/// by the acceleration along the same way, both in closed form, from cell to cell. For systems in
/// two or three dimensions; particles of walls go straight on, as their motion is given.
///
/// The velocity of a particle changes at the rate a, that at a fixed place at u_t = a - (u grad) u.
/// Frozen fields have no u_t and a_t: in a step h, places are off by h^2/2 u_t and velocities by
/// h^2/2 a_t. So the order is 1. But steady flows are followed exactly up to the projection, and
/// where they are linear for steps of any length, as long as the way is on the mesh.
///
/// What else drifts or is kicked, densities, moves by its rate at the end of the step, which a
/// second evaluation forms: so velocities and densities take turns as in symplectic Euler. With
/// both frozen at the start, sound would swell as in forward Euler.
class XIvas final : public Integrator {
 public:
  static constexpr std::string_view name = "x_ivas";
  static constexpr std::string_view summary =
      "order 1, along the streamlines of velocity and acceleration on a background mesh";
  static constexpr int order = 1;

  std::string missing_in(System& system) const override;
  void advance_one_step(System& system, double time, double step) override;

 private:
  template <int D>
  void go_along_streamlines(System& system, double step);
};

}  // namespace mote
