#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace mote {

class ForceSeries;

/// Values that an integrator moves on, and where the system leaves their rate of change.
struct Evolving {
  std::span<double> value;
  std::span<const double> rate;
};

/// What is known of a system of point masses under nothing but their own gravity.
struct PointMasses {
  double gravitational_constant = 1;
  std::span<const double> mass;
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

  /// Whether this is an equation of second order without velocities, x'' = f(t, x): part k of what
  /// is kicked is the velocity of part k of what drifts, and kick rates follow from time and
  /// drifted values alone.
  virtual bool falls_freely() const { return false; }

  /// Whether the state is these values and nothing else, so that a path through them is a path of
  /// the system.
  virtual bool has_paths() const { return falls_freely(); }

  /// Whether nothing in the system needs the length of a step before it is taken, so that a method
  /// may choose it.
  virtual bool bears_any_step() const { return falls_freely(); }

  /// Numbers a place in space, where the first part of what drifts is places and the first part of
  /// what is kicked their velocities; else 0.
  virtual int dimension() const { return 0; }

  /// Along every axis the length after which these places come again; 0 where space is not
  /// periodic.
  virtual std::array<double, 3> periods() const { return {}; }

  /// Which of these places are of walls, whose motion is given: not 0 for those. Empty if none is.
  virtual std::span<const std::uint8_t> walls() const { return {}; }

  /// The masses at these places, where their gravity is all there is and none of them is spread.
  virtual std::optional<PointMasses> point_masses() const { return std::nullopt; }

  /// Accelerations along paths, of systems that have them as power series; else null.
  virtual ForceSeries* force_series() { return nullptr; }
};

}  // namespace mote
