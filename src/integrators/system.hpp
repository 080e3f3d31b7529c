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

  /// Whether kick rates depend on what is kicked, and `update_rates_ahead` takes that into account.
  virtual bool predicts() const { return false; }

  /// Kick rates with every kicked value thought carried on by `ahead` times its last rate.
  virtual void update_rates_ahead(double time, double /*ahead*/) { update_kick_rates(time); }

  /// Whether the kick rates are still those of the state: nobody has changed it since they were
  /// formed.
  virtual bool rates_are_current() const { return false; }

  /// Whether integrators keep what rounding loses at each addition for the next one. Not worth its
  /// memory where the discretisation's error is far above that.
  virtual bool compensates() const { return true; }
};

}  // namespace mote
