#pragma once

#include <memory>
#include <vector>

#include "mote/models/tracer_mesh.hpp"
#include "mote/models/tracers_options.hpp"

namespace mote {

/// Material points in a velocity field given by formulas: dx/dt = u(x, t), by an integrator, or in
/// steps along the streamlines of the field that is interpolated on a mesh of simplices, as it is
/// at the middle of the step (X-IVAS with a given velocity; Nadukandi 2014). A tracer that comes
/// out of the mesh stays where it left.
template <int D>
class Tracers final : public Model {
 public:
  /// Throws InputError for a set-up that does not fit.
  Tracers(const TracersOptions& options, SpaceSetup setup);

  Cloud& cloud() override { return cloud_; }
  const Cloud& cloud() const override { return cloud_; }
  Frame frame() const override { return Frame::lagrangian; }

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return {}; }
  bool drifts_freely() const override { return false; }
  bool bears_any_step() const override { return mesh_ == nullptr; }
  void prepare(double /*time*/) override {}
  void update_drift_rates(double time) override;
  void update_kick_rates(double /*time*/) override {}

  void end_step(double time, double step) override;
  void update_dependent_fields() override;
  void inspect() const override;
  void start_afresh() override;
  void restore(const Cloud& state) override;

  std::vector<Conserved> conserved() const override { return {}; }
  std::vector<Reading> readings() const override;
  std::vector<StepLimit> step_limits() override { return {}; }
  double longest_step(double time, double courant) override;
  PairWork pair_work() const override { return {}; }
  std::vector<std::string> remarks() const override;
  std::vector<std::string> warnings() const override;
  std::span<const Body> bodies() const override { return start_.bodies; }
  double spacing() const override { return start_.spacing; }
  Parameters parameters() const override;

 private:
  void bind();
  bool is_steady() const;
  void note_invariants();
  void follow(Index i, double time, double step);
  void bring_back_into_the_box();
  Index left() const;
  Eigen::Map<Vec<D>> position(Index i) const {
    return Eigen::Map<Vec<D>>(position_.data() + std::ptrdiff_t{i} * D);
  }
  Triple place_of(Index i) const;
  double invariant(std::size_t number, Index i) const;
  double kept(std::size_t number) const;

  TracersOptions options_;
  SpaceStart start_;
  FreeStream<D> velocity_formulas_;
  std::vector<PlaceFunction> invariants_;
  Cloud cloud_;
  std::unique_ptr<TracerMesh<D>> mesh_;  ///< of streamlines; else null
  std::span<double> position_, velocity_, left_at_;
  std::vector<Evolving> drifted_;  ///< nothing, along streamlines
  std::vector<Index> cells_;
  std::vector<int> crossings_;  ///< of every tracer in the last step
  double time_ = 0, courant_number_ = 0;
};

extern template class Tracers<2>;
extern template class Tracers<3>;

}  // namespace mote
