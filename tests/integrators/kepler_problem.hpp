#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "mote/exact/kepler_orbit.hpp"
#include "mote/integrators/system.hpp"

namespace mote::test {

/// A body that orbits a fixed mass (mu = a = 1), from its pericentre on.
class KeplerProblem final : public System {
 public:
  explicit KeplerProblem(double eccentricity) : orbit_({.eccentricity = eccentricity}) { put(0); }
  KeplerProblem(const KeplerProblem&) = delete;
  KeplerProblem& operator=(const KeplerProblem&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  bool falls_freely() const override { return true; }
  void prepare(double) override { prepared_ = position_; }
  void update_drift_rates(double) override { rate_ = velocity_; }
  void update_kick_rates(double) override {
    ++evaluations;
    const double r = std::hypot(prepared_[0], prepared_[1]);
    for (std::size_t d = 0; d < 2; ++d) acceleration_[d] = -prepared_[d] / (r * r * r);
  }

  /// Puts the body where it is at this time.
  void put(double time) {
    const OrbitState exact = orbit_.at(time);
    position_ = exact.position;
    velocity_ = exact.velocity;
  }

  std::vector<double> state() const {
    return {position_[0], position_[1], velocity_[0], velocity_[1]};
  }
  void put(const std::vector<double>& state) {
    position_ = {state[0], state[1]};
    velocity_ = {state[2], state[3]};
  }

  double position_error(double time) const {
    const OrbitState exact = orbit_.at(time);
    return std::hypot(position_[0] - exact.position[0], position_[1] - exact.position[1]);
  }
  double velocity_error(double time) const {
    const OrbitState exact = orbit_.at(time);
    return std::hypot(velocity_[0] - exact.velocity[0], velocity_[1] - exact.velocity[1]);
  }
  double error(double time) const { return std::max(position_error(time), velocity_error(time)); }

  int evaluations = 0;

 private:
  KeplerOrbit orbit_;
  std::array<double, 2> position_{}, velocity_{}, rate_{}, acceleration_{}, prepared_{};
  std::array<Evolving, 1> drifted_{{{position_, rate_}}};
  std::array<Evolving, 1> kicked_{{{velocity_, acceleration_}}};
};

inline constexpr double period = 2 * std::numbers::pi;

}  // namespace mote::test
