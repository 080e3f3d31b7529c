#pragma once

#include <span>

namespace mote {

/// Values that an integrator moves on, and where the system leaves their rate of change.
struct Evolving {
  std::span<double> value;
  std::span<const double> rate;
};

/// A system of ordinary differential equations in two parts, as symplectic methods want it:
/// `drifted` values (positions, densities) whose rates follow from the velocities, and `kicked`
/// values (velocities) whose rates are accelerations. An equation with one part leaves the other
/// empty.
class System {
 public:
  virtual ~System() = default;

  virtual std::span<const Evolving> drifted() = 0;
  virtual std::span<const Evolving> kicked() = 0;

  /// Whether drift rates follow from the kicked values alone, as dx/dt = v does. Not so for a
  /// density that is carried by the continuity equation.
  virtual bool drifts_freely() const = 0;

  /// Called whenever drifted values have changed, before rates are wanted: neighbours, sums.
  virtual void prepare(double time) = 0;
  virtual void update_drift_rates(double time) = 0;
  virtual void update_kick_rates(double time) = 0;
};

}  // namespace mote
