#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "mote/models/bodies_options.hpp"
#include "mote/models/collisions.hpp"
#include "mote/models/gravity_series.hpp"
#include "mote/models/own_gravity.hpp"

namespace mote {

/// Bodies under their own gravity in unbounded space: dx/dt = v, dv/dt = -G grad phi, with the
/// potential phi of all others. They are points, or have their mass spread by a core. Single masses
/// with a radius are watched for collisions, which change nothing.
template <int D>
class Bodies final : public Model {
 public:
  /// Throws InputError for a set-up that does not fit, and for two bodies on one place or in
  /// contact.
  Bodies(const BodiesOptions& options, SpaceSetup setup);

  Cloud& cloud() override { return cloud_; }
  const Cloud& cloud() const override { return cloud_; }
  Frame frame() const override { return Frame::lagrangian; }

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  bool falls_freely() const override { return true; }
  bool has_paths() const override { return !collisions_.exist(); }
  int dimension() const override { return D; }
  std::optional<PointMasses> point_masses() const override;
  ForceSeries* force_series() override { return series_.get(); }
  void prepare(double /*time*/) override {}
  void update_drift_rates(double /*time*/) override {}
  void update_kick_rates(double time) override;

  void begin_step(double time, double step) override;
  void end_step(double time, double step) override;
  void update_dependent_fields() override {}
  void complete_fields() override;
  void inspect() const override;
  void restore(const Cloud& state) override;

  std::vector<Conserved> conserved() const override;
  std::vector<Reading> readings() const override;
  std::vector<StepLimit> step_limits() override { return {}; }
  double longest_step(double time, double courant) override;
  /// Evaluations are the times that accelerations were formed, or power series of them. Pairs are
  /// counted where they are summed one by one.
  PairWork pair_work() const override;
  std::vector<std::string> warnings() const override;
  std::vector<std::string> remarks() const override;
  std::span<const Body> bodies() const override { return start_.bodies; }
  double spacing() const override { return start_.spacing; }
  Parameters parameters() const override;

 private:
  void add(const BodiesOptions& options);
  void bind();
  void form_accelerations() const;
  Sources<D> sources() const { return {position_, mass_, options_.core_size}; }
  Vec<D> at(std::span<const double> vectors, Index i) const {
    return Vec<D>::Map(vectors.data() + std::ptrdiff_t{i} * D);
  }
  Vec<D> weighted_mean(std::span<const double> vectors) const;
  double virial_ratio() const;
  double least_separation() const;
  void refuse_contact() const;
  /// Contacts so far, those before a restart too.
  std::int64_t collisions() const;
  std::string collisions_in_words() const;

  static constexpr std::size_t told_collisions = 5;

  BodiesOptions options_;
  SpaceStart start_;
  Cloud cloud_;
  std::unique_ptr<OwnGravity<D>> gravity_;
  std::unique_ptr<GravitySeries<D>> series_;  ///< of points
  std::span<double> position_, velocity_, acceleration_, mass_, potential_;
  std::vector<Evolving> drifted_, kicked_;
  mutable std::vector<double> accelerated_at_;  ///< places that the accelerations are of
  std::int64_t evaluations_ = 0;                ///< times that a step asked for new accelerations
  mutable bool are_new_ = false;                ///< no step has asked for them yet
  Collisions<D> collisions_;
  std::span<double> met_;  ///< contacts that each body has begun, if any are watched for
  std::vector<Collision> first_collisions_;
};

extern template class Bodies<2>;
extern template class Bodies<3>;

}  // namespace mote
