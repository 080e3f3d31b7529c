#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "mote/integrators/system.hpp"

namespace mote::test {

/// Particles whose accelerations do not change.
class FreeFall final : public System {
 public:
  FreeFall(std::vector<double> position, std::vector<double> velocity,
           std::vector<double> acceleration)
      : position(std::move(position)),
        velocity(std::move(velocity)),
        acceleration(std::move(acceleration)) {}
  FreeFall(const FreeFall&) = delete;
  FreeFall& operator=(const FreeFall&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {}

  std::vector<double> position, velocity, acceleration;

 private:
  std::array<Evolving, 1> drifted_{{{position, velocity}}};
  std::array<Evolving, 1> kicked_{{{velocity, acceleration}}};
};

/// Oscillators pushed by a force that changes with time,
///   x'' = -w^2 x + cos(n t),   x = a cos(w t) + b sin(w t) + cos(n t)/(w^2 - n^2).
/// The force is formed in `prepare`, and rates only from what was prepared, so that a method which
/// forgets a call or passes a wrong time loses its order.
class ForcedOscillators final : public System {
 public:
  ForcedOscillators() {
    for (std::size_t i = 0; i < count; ++i) {
      position_[i] = exact_position(i, 0);
      velocity_[i] = exact_velocity(i, 0);
    }
  }
  ForcedOscillators(const ForcedOscillators&) = delete;
  ForcedOscillators& operator=(const ForcedOscillators&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  void prepare(double time) override {
    for (std::size_t i = 0; i < count; ++i)
      force_[i] = -w[i] * w[i] * position_[i] + std::cos(n * time);
  }
  void update_drift_rates(double) override { rate_ = velocity_; }
  void update_kick_rates(double) override { acceleration_ = force_; }

  /// Root mean square of the errors of position and velocity.
  double error(double time) const {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      sum += std::pow(position_[i] - exact_position(i, time), 2) +
             std::pow(velocity_[i] - exact_velocity(i, time), 2);
    return std::sqrt(sum / (2 * count));
  }

 private:
  static constexpr std::size_t count = 3;
  static constexpr std::array<double, count> w{0.8, 1.3, 1.9}, a{1, -0.5, 0.4}, b{0.3, 0.7, -0.6};
  static constexpr double n = 1.1;

  static double exact_position(std::size_t i, double t) {
    return a[i] * std::cos(w[i] * t) + b[i] * std::sin(w[i] * t) +
           std::cos(n * t) / (w[i] * w[i] - n * n);
  }
  static double exact_velocity(std::size_t i, double t) {
    return w[i] * (b[i] * std::cos(w[i] * t) - a[i] * std::sin(w[i] * t)) -
           n * std::sin(n * t) / (w[i] * w[i] - n * n);
  }

  std::array<double, count> position_, velocity_, rate_, acceleration_, force_;
  std::array<Evolving, 1> drifted_{{{position_, rate_}}};
  std::array<Evolving, 1> kicked_{{{velocity_, acceleration_}}};
};

}  // namespace mote::test
