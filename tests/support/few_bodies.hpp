#pragma once

#include <array>
#include <utility>
#include <vector>

#include "mote/integrators/system.hpp"
#include "mote/models/gravity_series.hpp"

namespace mote::test {

/// Point masses in D dimensions, G = 1, with nothing but their forces as power series.
template <int D>
class FewBodies : public System {
 public:
  FewBodies(std::vector<double> mass, std::vector<double> position, std::vector<double> velocity)
      : mass(std::move(mass)), position(std::move(position)), velocity(std::move(velocity)) {}
  FewBodies(const FewBodies&) = delete;
  FewBodies& operator=(const FewBodies&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  bool falls_freely() const override { return true; }
  int dimension() const override { return D; }
  std::optional<PointMasses> point_masses() const override { return PointMasses{1, mass}; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {
    const Eigen::VectorXd place =
        Eigen::VectorXd::Map(position.data(), static_cast<Eigen::Index>(position.size()));
    Eigen::VectorXd force;
    series_.expand({&place, 1}, {&force, 1}, {});
    acceleration.assign(force.begin(), force.end());
  }
  ForceSeries* force_series() override { return &series_; }

  std::vector<double> mass, position, velocity, acceleration = position;

 private:
  GravitySeries<D> series_{1, mass};
  std::array<Evolving, 1> drifted_{{{position, velocity}}};
  std::array<Evolving, 1> kicked_{{{velocity, acceleration}}};
};

}  // namespace mote::test
