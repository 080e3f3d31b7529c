#pragma once

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "mote/models/free_stream.hpp"
#include "mote/models/induced_velocity.hpp"
#include "mote/models/remeshing.hpp"
#include "mote/models/vortex_bodies.hpp"
#include "mote/models/vortex_diffusion.hpp"
#include "mote/models/vortex_moments.hpp"
#include "mote/models/vortex_space_moments.hpp"

namespace mote {

/// The vortex method: dx/dt = u, (40) of Isshiki (2014), with the velocity of all vortices by the
/// volume integral of (38) and a free stream. In space circulation alpha stretches:
///   d alpha_i/dt = (grad u)^T alpha_i  or  (alpha_i . grad) u
/// (Winckelmans & Leonard 1993), the transposed and the classical form. Friction changes
/// circulations, sizes or places
/// (`VortexDiffusion`); every so many steps the vortices may be put back on a lattice. Where there
/// are walls, in the plane, they do both (`VortexBodies`), and the flow may start without a vortex.
template <int D>
class Vortex final : public Model {
 public:
  /// Throws InputError for a set-up that does not fit.
  Vortex(const VortexOptions& options, SpaceSetup setup);

  Cloud& cloud() override { return vortices_.cloud(); }
  const Cloud& cloud() const override { return vortices_.cloud(); }
  Frame frame() const override { return Frame::lagrangian; }

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return false; }
  bool compensates() const override { return options_.remesh_every == 0 && !bodies_; }
  bool bears_any_step() const override { return compensates(); }
  bool has_paths() const override;
  void prepare(double /*time*/) override {}
  void update_drift_rates(double time) override;
  void update_kick_rates(double time) override;

  void begin_step(double time, double step) override;
  void end_step(double time, double step) override;
  void update_dependent_fields() override;
  void complete_fields() override;
  void stand_at(double time) override;
  void inspect() const override;
  void restore(const Cloud& state) override;

  std::vector<Conserved> conserved() const override;
  std::vector<Reading> readings() const override;
  std::vector<StepLimit> step_limits() override;
  double longest_step(double time, double courant) override;
  std::vector<Advice> advice() const override;
  PairWork pair_work() const override;
  std::vector<std::string> remarks() const override;
  std::span<const Body> bodies() const override { return vortices_.start().bodies; }
  Triple force_on(std::size_t body) const override;
  std::vector<std::string> warnings() const override;
  double spacing() const override { return vortices_.start().spacing; }
  Parameters parameters() const override;

 private:
  Sources<D> sources() const;
  void bind();
  void need_no_net_circulation();
  double core_size_at(double time) const;
  void remesh();
  void grow_older();
  void end_step_beside_walls(double time, double step);
  VortexLatticeOptions lattice() const;
  void add_stretching();
  std::conditional_t<D == 2, VortexMoments, SpaceVortexMoments> moments() const;
  void learn_from_start();
  bool keeps_impulse() const;
  bool keeps_angular_impulse() const;

  VortexOptions options_;
  VortexParticles<D> vortices_;
  std::unique_ptr<InducedVelocity<D>> induced_;
  std::unique_ptr<VortexDiffusion<D>> diffusion_;
  FreeStream<D> free_stream_;
  std::unique_ptr<VortexBodies> bodies_;  ///< null without walls
  std::vector<double> circulation_rate_;
  std::vector<double> gradient_;  ///< of the velocity, in space
  std::vector<Evolving> drifted_, kicked_;

  double time_ = 0;       ///< that the state is of, or the step begins at
  double core_at_start_;  ///< of the step

  /// For which the velocities have been summed.
  struct Summed {
    double time = 0, core_size = -1;
    std::vector<double> position, circulation;
  } summed_;
  std::int64_t evaluations_ = 0;  ///< times that velocities were summed

  bool has_circulation_ = false, is_a_pair_ = false;  ///< at the start
  struct Course {
    std::int64_t remeshings = 0;
    double dropped = 0;
  } course_;
};

template <>
VortexMoments Vortex<2>::moments() const;
template <>
std::vector<Conserved> Vortex<2>::conserved() const;
template <>
std::vector<Reading> Vortex<2>::readings() const;
template <>
SpaceVortexMoments Vortex<3>::moments() const;
template <>
std::vector<Conserved> Vortex<3>::conserved() const;
template <>
std::vector<Reading> Vortex<3>::readings() const;

extern template class Vortex<2>;
extern template class Vortex<3>;

}  // namespace mote
