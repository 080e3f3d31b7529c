#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "mote/integrators/system.hpp"
#include "support/outer_planets.hpp"

namespace mote::test {

/// Point masses in space, pair by pair, and how often their accelerations were formed.
class MassPoints final : public System {
 public:
  MassPoints(double constant, std::vector<double> mass, std::vector<double> position,
             std::vector<double> velocity)
      : constant(constant),
        mass(std::move(mass)),
        position(std::move(position)),
        velocity(std::move(velocity)),
        acceleration(this->position.size()) {}
  MassPoints(const MassPoints&) = delete;
  MassPoints& operator=(const MassPoints&) = delete;
  MassPoints copy() const { return {constant, mass, position, velocity}; }

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  bool falls_freely() const override { return true; }
  int dimension() const override { return 3; }
  std::optional<PointMasses> point_masses() const override { return PointMasses{constant, mass}; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {
    ++evaluations;
    std::ranges::fill(acceleration, 0.0);
    for (std::size_t i = 0; i < mass.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) attract(i, j);
  }

  double constant;
  std::vector<double> mass, position, velocity, acceleration;
  int evaluations = 0;

 private:
  void attract(std::size_t i, std::size_t j) {
    std::array<double, 3> apart;
    double square = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      apart[d] = position[3 * i + d] - position[3 * j + d];
      square += apart[d] * apart[d];
    }
    const double pull = constant / (square * std::sqrt(square));
    for (std::size_t d = 0; d < 3; ++d) {
      acceleration[3 * i + d] -= pull * mass[j] * apart[d];
      acceleration[3 * j + d] += pull * mass[i] * apart[d];
    }
  }

  std::array<Evolving, 1> drifted_{{{position, velocity}}};
  std::array<Evolving, 1> kicked_{{{velocity, acceleration}}};
};

/// A test particle about a mass at rest, G m = 1, from the pericentre of an orbit with half axis 1.
inline MassPoints kepler(double eccentricity) {
  return {1,
          {1, 0},
          {0, 0, 0, 1 - eccentricity, 0, 0},
          {0, 0, 0, 0, std::sqrt((1 + eccentricity) / (1 - eccentricity)), 0}};
}

/// Two bodies about their centre of mass with that orbit between them.
inline MassPoints binary(double eccentricity) {
  const double x = 1 - eccentricity, v = std::sqrt((1 + eccentricity) / x);
  return {1, {0.6, 0.4}, {-0.4 * x, 0, 0, 0.6 * x, 0, 0}, {0, -0.4 * v, 0, 0, 0.6 * v, 0}};
}

/// The Sun and the giant planets.
inline MassPoints giants() {
  std::vector<double> mass, position, velocity;
  for (const PlanetStart& body : outer_planets) {
    mass.push_back(body.mass);
    position.insert(position.end(), body.position.begin(), body.position.end());
    velocity.insert(velocity.end(), body.velocity.begin(), body.velocity.end());
  }
  return {gauss_constant_squared, mass, position, velocity};
}

inline double distance(const std::vector<double>& x, const std::vector<double>& y) {
  double square = 0;
  for (std::size_t k = 0; k < x.size(); ++k) square += (x[k] - y[k]) * (x[k] - y[k]);
  return std::sqrt(square);
}

/// In long double, so that the energy's own rounding does not show.
inline long double energy(const MassPoints& bodies) {
  long double sum = 0;
  for (std::size_t i = 0; i < bodies.mass.size(); ++i) {
    long double speed = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const long double v = bodies.velocity[3 * i + d];
      speed += v * v;
    }
    sum += bodies.mass[i] * speed / 2;
    for (std::size_t j = 0; j < i; ++j) {
      long double square = 0;
      for (std::size_t d = 0; d < 3; ++d) {
        const long double x =
            static_cast<long double>(bodies.position[3 * i + d]) - bodies.position[3 * j + d];
        square += x * x;
      }
      sum -= static_cast<long double>(bodies.constant) * bodies.mass[i] * bodies.mass[j] /
             std::sqrt(square);
    }
  }
  return sum;
}

}  // namespace mote::test
