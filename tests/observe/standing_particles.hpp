#pragma once

#include <functional>
#include <string>

#include "mote/models/model.hpp"

namespace mote::test {

/// A model in space that only has a state: particles of water and of a wall named bed.
class StandingParticles final : public Model {
 public:
  using Function = std::function<double(const Triple& place)>;

  explicit StandingParticles(int dimension, double spacing)
      : dimension_(dimension), spacing_(spacing), cloud_(dimension, 0) {}

  /// Particles at the middles of the cells of a box, of the water (0) or of the bed (1).
  void fill(const Triple& lower, const Triple& upper, int body) {
    Triple place{};
    const double start = 0.5 * spacing_;
    for (place[2] = dimension_ == 3 ? lower[2] + start : 0; place[2] < upper[2] || dimension_ == 2;
         place[2] += spacing_) {
      for (place[1] = lower[1] + start; place[1] < upper[1]; place[1] += spacing_)
        for (place[0] = lower[0] + start; place[0] < upper[0]; place[0] += spacing_)
          add(place, body);
      if (dimension_ == 2) break;
    }
  }

  void add(const Triple& place, int body) {
    places_.push_back(place);
    body_.push_back(body);
  }

  /// Makes the cloud; the velocity is (u, 2 u) or (u, 2 u, 3 u).
  void settle(const Function& pressure, const Function& u) {
    const auto d = static_cast<std::size_t>(dimension_);
    cloud_ = Cloud(dimension_, static_cast<Index>(places_.size()));
    cloud_.add("velocity", FieldKind::vector, "m/s");
    cloud_.add("pressure", FieldKind::scalar, "Pa");
    cloud_.add("body", FieldKind::scalar, "1");
    for (std::size_t i = 0; i < places_.size(); ++i) {
      for (std::size_t c = 0; c < d; ++c) {
        cloud_.position()[i * d + c] = places_[i][c];
        cloud_.values("velocity")[i * d + c] = static_cast<double>(c + 1) * u(places_[i]);
      }
      cloud_.values("pressure")[i] = pressure(places_[i]);
      cloud_.values("body")[i] = body_[i];
    }
  }

  Cloud& cloud() override { return cloud_; }
  const Cloud& cloud() const override { return cloud_; }
  Frame frame() const override { return Frame::lagrangian; }
  void update_dependent_fields() override {}
  void inspect() const override {}
  std::vector<Conserved> conserved() const override { return {{"mass", 1, 1}}; }
  std::vector<StepLimit> step_limits() override { return {}; }
  PairWork pair_work() const override { return {}; }
  std::vector<std::string> remarks() const override { return {}; }
  std::vector<Reading> readings() const override { return {{"kinetic_energy", 1}}; }
  std::span<const Body> bodies() const override { return bodies_; }
  double spacing() const override { return spacing_; }
  Triple force_on(std::size_t body) const override { return {static_cast<double>(body), 7, 8}; }
  Parameters parameters() const override { return {}; }
  std::span<const Evolving> drifted() override { return {}; }
  std::span<const Evolving> kicked() override { return {}; }
  bool drifts_freely() const override { return true; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {}

 private:
  int dimension_;
  double spacing_;
  std::vector<Triple> places_;
  std::vector<int> body_;
  std::vector<Body> bodies_{{"water", BodyKind::fluid}, {"bed", BodyKind::wall}};
  Cloud cloud_;
};

}  // namespace mote::test
