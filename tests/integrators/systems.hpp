#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
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
  bool falls_freely() const override { return true; }
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
  bool falls_freely() const override { return true; }
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

/// Planets about a fixed sun that do not feel each other, x'' = -x/|x|^3, on one ellipse of
/// semi-major axis 1 and period 2 pi: the first at its pericentre at time 0, the others behind by
/// equal times. It counts how often accelerations are formed.
class Planets final : public System {
 public:
  explicit Planets(double eccentricity, std::size_t count = 1)
      : eccentricity_(eccentricity), count_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Place start = exact(i, 0);
      for (const std::size_t c : {0, 1}) {
        position_.push_back(start[c]);
        velocity_.push_back(start[2 + c]);
      }
    }
    rate_ = acceleration_ = prepared_ = position_;
    drifted_ = {{{position_, rate_}}};
    kicked_ = {{{velocity_, acceleration_}}};
  }
  Planets(const Planets&) = delete;
  Planets& operator=(const Planets&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  bool falls_freely() const override { return true; }
  int dimension() const override { return 2; }
  void prepare(double) override { prepared_ = position_; }
  void update_drift_rates(double) override { rate_ = velocity_; }
  void update_kick_rates(double) override {
    ++evaluations;
    for (std::size_t i = 0; i < 2 * count_; i += 2) {
      const double distance = std::hypot(prepared_[i], prepared_[i + 1]);
      for (const std::size_t c : {i, i + 1})
        acceleration_[c] = -prepared_[c] / (distance * distance * distance);
    }
  }

  /// Root mean square of the planets' distances, in phase space, from where they are at `time`.
  double error(double time) const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const Place end = exact(i, time);
      for (std::size_t c = 0; c < 2; ++c)
        sum += std::pow(position_[2 * i + c] - end[c], 2) +
               std::pow(velocity_[2 * i + c] - end[2 + c], 2);
    }
    return std::sqrt(sum / static_cast<double>(count_));
  }

  int evaluations = 0;

 private:
  using Place = std::array<double, 4>;

  /// (cos E - e, s sin E) with s^2 = 1 - e^2 and Kepler's equation E - e sin E = t, and velocity.
  Place exact(std::size_t planet, double time) const {
    const double e = eccentricity_, s = std::sqrt(1 - e * e);
    const double phase =
        2 * std::numbers::pi * static_cast<double>(planet) / static_cast<double>(count_);
    const double anomaly = eccentric_anomaly(time + phase);
    const double cosine = std::cos(anomaly), sine = std::sin(anomaly), speed = 1 / (1 - e * cosine);
    return {cosine - e, s * sine, -speed * sine, speed * s * cosine};
  }
  double eccentric_anomaly(double mean_anomaly) const {
    const double e = eccentricity_;
    double result = mean_anomaly;
    for (int k = 0; k < 60; ++k)
      result -= (result - e * std::sin(result) - mean_anomaly) / (1 - e * std::cos(result));
    return result;
  }

  double eccentricity_;
  std::size_t count_;
  std::vector<double> position_, velocity_, rate_, acceleration_, prepared_;
  std::array<Evolving, 1> drifted_, kicked_;
};

/// A body on a line that is let go where it is at rest and then follows x'' = f(x).
class Body final : public System {
 public:
  Body(double place, std::function<double(double)> acceleration)
      : place_{place}, law_(std::move(acceleration)) {}
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  bool falls_freely() const override { return true; }
  void prepare(double time) override {
    last_time = time;
    prepared_ = place_[0];
  }
  void update_drift_rates(double) override { rate_ = velocity_; }
  void update_kick_rates(double) override { acceleration_[0] = law_(prepared_); }

  double place() const { return place_[0]; }
  double velocity() const { return velocity_[0]; }

  double last_time = 0;

 private:
  std::array<double, 1> place_, velocity_{0}, rate_{0}, acceleration_{0};
  double prepared_ = 0;
  std::function<double(double)> law_;
  std::array<Evolving, 1> drifted_{{{place_, rate_}}};
  std::array<Evolving, 1> kicked_{{{velocity_, acceleration_}}};
};

/// x'' = -w^2 sin x from x = 1.
inline Body pendulum(double frequency = 1) {
  return Body(1, [w = frequency](double angle) { return -w * w * std::sin(angle); });
}

/// An oscillator whose acceleration depends on its velocity, x'' = -x - 2 c x', started from x = 1
/// at rest; it predicts, keeps its rates from step to step, and counts how often they are formed.
class DampedOscillator final : public System {
 public:
  DampedOscillator() = default;
  DampedOscillator(const DampedOscillator&) = delete;
  DampedOscillator& operator=(const DampedOscillator&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  void prepare(double) override { prepared_ = position_; }
  void update_drift_rates(double) override { rate_ = velocity_; }
  void update_kick_rates(double) override { form_rates(velocity_[0]); }
  bool predicts() const override { return true; }
  void update_rates_ahead(double, double ahead) override {
    form_rates(velocity_[0] + ahead * acceleration_[0]);
  }
  bool rates_are_current() const override { return evaluations > 0; }
  bool compensates() const override { return false; }

  double error(double time) const {
    const double w = std::sqrt(1 - c * c), decay = std::exp(-c * time);
    const double position = decay * (std::cos(w * time) + c / w * std::sin(w * time));
    const double velocity = -decay / w * std::sin(w * time);
    return std::hypot(position_[0] - position, velocity_[0] - velocity);
  }

  int evaluations = 0;

 private:
  static constexpr double c = 0.3;

  void form_rates(double velocity) {
    acceleration_[0] = -prepared_[0] - 2 * c * velocity;
    ++evaluations;
  }

  std::array<double, 1> position_{1}, velocity_{0}, rate_{0}, acceleration_{0}, prepared_{1};
  std::array<Evolving, 1> drifted_{{{position_, rate_}}};
  std::array<Evolving, 1> kicked_{{{velocity_, acceleration_}}};
};

}  // namespace mote::test
