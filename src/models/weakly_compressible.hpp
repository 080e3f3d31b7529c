#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "mote/models/body_force.hpp"
#include "mote/models/equation_of_state.hpp"
#include "mote/models/fluid_neighbours.hpp"
#include "mote/models/removed_fluid.hpp"
#include "mote/models/wall_motion.hpp"
#include "mote/models/weakly_compressible_options.hpp"
#include "mote/operators/terms/fluid_terms.hpp"

namespace mote {

/// A fluid that is a little compressible, so that its pressure follows from its density (Monaghan
/// 1994):
///   D rho/Dt = -rho div u + diffusion,   Du/Dt = -grad p/rho + viscosity + gravity + force,
///   Dx/Dt = u.
/// Every particle has the mass rho0 spacing^D and the volume m/rho. Derivatives are sums over pairs
/// (see FluidTerms), or taken by the scenario's operator.
///
/// Walls are particles too. An extrapolated wall particle carries on the fluid's pressure with the
/// weight of the fluid between (Adami, Hu & Adams 2012, (27)), and a velocity that goes on beyond
/// the wall's surface as it does before it: linearly through the wall's own velocity, for slip in
/// the normal direction only. So pair sums see the wall as more fluid.
///
/// Particles stand in their order in space, and rows of neighbours reach a little further than the
/// kernel, so that they last for several steps.
template <int D>
class WeaklyCompressible final : public Model {
 public:
  WeaklyCompressible(const WeaklyCompressibleOptions& options, SpaceSetup setup);

  Cloud& cloud() override { return cloud_; }
  const Cloud& cloud() const override { return cloud_; }
  Frame frame() const override { return Frame::lagrangian; }

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  int dimension() const override { return D; }
  Triple periods() const override;
  std::span<const std::uint8_t> walls() const override { return idle_; }
  void prepare(double time) override;
  void update_drift_rates(double) override {}
  void update_kick_rates(double time) override { update_rates_ahead(time, 0); }
  bool predicts() const override { return true; }
  bool compensates() const override { return false; }
  bool rates_are_current() const override { return rates_are_current_; }
  void update_rates_ahead(double time, double ahead) override;

  void begin_step(double time, double step) override;
  void end_step(double time, double step) override;
  void update_dependent_fields() override {}
  void complete_fields() override;
  void complete_snapshot() override;
  void inspect() const override;
  void start_afresh() override;
  void restore(const Cloud& state) override;
  double longest_step(double time, double courant) override;
  std::vector<StepLimit> step_limits() override { return {}; }

  std::vector<Conserved> conserved() const override;
  std::vector<Reading> readings() const override;
  std::vector<std::string> warnings() const override;
  PairWork pair_work() const override { return work_; }
  std::vector<std::string> remarks() const override;
  Parameters parameters() const override;
  std::span<const Body> bodies() const override { return start_.bodies; }
  double spacing() const override { return start_.spacing; }
  Triple force_on(std::size_t body) const override;

 private:
  using Line = PairLine<D>;

  void refuse_what_does_not_go_together() const;
  void choose_coefficients();
  void fill_cloud();
  void start_particle(Index i);
  void name_parts();
  void rebuild(double time, double travel);
  void find_neighbours();
  void find_neighbours(ListForm form);
  double skin_for(double travel) const;
  bool needs_all_neighbours() const;
  bool drags_at_ghosts() const;
  void assign_roles();
  void rearrange(std::span<const Index> order);
  void remove_what_left(double time);
  std::string_view side_left(Index i) const;
  bool is_wall(Index i) const { return idle_[static_cast<std::size_t>(i)] != 0; }
  const Body& body_of(Index i) const;
  const WallPlace& place_of(Index i) const;

  void write_fluid_lines(double ahead);
  void observe_walls(double time);
  void write_wall_lines();
  void extrapolate_to(Index i);
  void write_image_lines();
  void sum_densities();
  bool uses_operator() const;
  void prepare_operator();
  void add_operator_terms();
  void add_first_derivatives();
  void add_laplacian();
  PairSums& sums_of_receiver(Index k) {
    return sums_[static_cast<std::size_t>(receiver_of_operator_[static_cast<std::size_t>(k)])];
  }
  PairPoints<D> points_of_pairs() const { return {lines_, roles_, carrying_}; }
  FluidSpread<D> spread_of(Index i) const;
  void refresh_lines(double time);
  void add_density_correction();
  void finish_rates(double time, double ahead);
  void copy_slopes_to_images();
  void continue_slopes_into_walls();
  void move_walls(double time);
  void shift_particles(double time, double step);
  double change_by_shift(const FluidSpread<D>& spread, double density, const Vec<D>& shift) const;
  bool keeps_volume() const;
  bool walls_travel() const;
  double volume();
  void keep_volume();
  const Vec<D>& gravity() const { return body_force_.gravity(); }

  struct Energy {
    double kinetic = 0, potential = 0, compression = 0;
    double total() const { return kinetic + potential + compression; }
  };
  Energy energy() const;
  template <class Term>
  double sum_over_fluid(Term term) const;

  const WallMotion& motion_of(Index i) const {
    return motions_[static_cast<std::size_t>(body_[i])];
  }

  WeaklyCompressibleOptions options_;
  SpaceSetup start_;
  EquationOfState state_;
  std::unique_ptr<FluidTerms<D>> terms_;
  std::unique_ptr<DifferentialOperator<D>> operator_;
  double smoothing_length_, reach_, mass_;
  FluidCoefficients<D> coefficients_;
  BodyForce<D> body_force_;

  Cloud cloud_;
  std::span<double> position_, velocity_, density_, pressure_, body_, id_, surface_;
  std::vector<double> acceleration_, density_rate_, kept_;
  std::vector<Evolving> drifted_, kicked_;
  std::vector<std::uint8_t> idle_;

  Points<D> points_;  ///< as the operator numbers them: the fluid, then all else
  NeighbourLists operator_lists_;
  std::vector<Index> number_, receiver_of_operator_;
  std::vector<Line> lines_of_operator_;
  std::vector<Vec<D>> carrying_of_operator_;  ///< velocities at which mass moves
  std::vector<Vec<D>> slopes_;                ///< of the density
  std::vector<Vec<D>> gains_;                 ///< of velocity by shifting
  std::vector<std::uint8_t> moves_;           ///< whether shifting moves a particle
  FluidNeighbours<D> neighbours_;
  std::vector<Index> order_;
  std::vector<Line> lines_;
  std::vector<PairSums> sums_;    ///< of every line; 0 between evaluations
  std::vector<PairRole> roles_;   ///< of every line
  std::vector<Vec<D>> carrying_;  ///< of every line, if it differs anywhere; see PairPoints
  std::vector<WallMotion> motions_;
  bool lists_are_current_ = false, rates_are_current_ = false;
  double now_ = 0;               ///< time of the last step's start
  double walls_at_ = 0;          ///< time at which the walls move as `motions_` says
  double skin_ = 0, moved_ = 0;  ///< how far lists reach beyond the kernel; how far particles went
  Index fluids_ = 0;             ///< fluid particles at the start
  double highest_speed_ = 0, highest_acceleration_ = 0, furthest_shift_ = 0;
  double dissipation_ = 0;
  double volume_ = 0;            ///< of the fluid at the step's start; 0 before the first
  std::vector<double> volumes_;  ///< of blocks of particles; work for `volume`
  PairWork work_;
  RemovedFluid<D> removed_;

  /// What the run came to, for the report.
  struct Course {
    double fastest = 0, fastest_at = 0;
    double dissipated = 0;
    double swelling = 0;  ///< of the fluid by numerical error, relative; put right
    std::int64_t rebuilds = 0, steps = 0;
  } course_;
};

extern template class WeaklyCompressible<2>;
extern template class WeaklyCompressible<3>;

}  // namespace mote
