#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mote/models/body_force.hpp"
#include "mote/models/flow_particles.hpp"
#include "mote/models/incompressible_options.hpp"
#include "mote/models/pair_weights.hpp"
#include "mote/operators/terms/fluid_terms.hpp"
#include "mote/solvers/linear_solver.hpp"

namespace mote {

/// Radius within which the number density n counts, in spacings (Koshizuka & Oka 1996).
inline constexpr double counted_within = 2.1;

/// Length s of the cone that is free of neighbours at a surface, in spacings (Marrone et al. 2010).
inline constexpr double cone_length = 1.33;

/// A fluid of constant density, whose pressure keeps its velocity free of divergence (Chorin 1968;
/// Koshizuka & Oka 1996; Cummins & Rudman 1999):
///   Du/Dt = -grad p/rho + nu lap u + gravity + force,   div u = 0,   Dx/Dt = u.
/// A step of dt is of second order: particles drift for dt/2, are kicked, and drift for dt/2. In
/// the middle, v = u + dt nu lap u is the velocity without pressure, gravity and force, and p
/// solves
///   lap p = rho/dt (div v - dt/2 tr(grad v grad v)) + rho div force,
/// the condition that the divergence vanishes where the particles are *after* the second drift.
/// All derivatives are those of the scenario's operator, so the matrix is made of its weights l_ij.
///
/// At walls the pressure goes on with the weight of the fluid, rho (g + force - a).(x_j - x_i) for
/// walls accelerated by a (Adami, Hu & Adams 2012, (27)), and the velocity linearly through the
/// wall's own. At a free surface the pressure is 0.
template <int D>
class Incompressible final : public Model {
 public:
  Incompressible(const IncompressibleOptions& options, SpaceSetup setup);

  Cloud& cloud() override { return particles_.cloud(); }
  const Cloud& cloud() const override { return particles_.cloud(); }
  Frame frame() const override { return Frame::lagrangian; }

  std::span<const Evolving> drifted() override { return {}; }
  std::span<const Evolving> kicked() override { return {}; }
  bool drifts_freely() const override { return true; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {}
  bool compensates() const override { return false; }

  void end_step(double time, double step) override;
  void update_dependent_fields() override {}
  void complete_fields() override;
  void inspect() const override;
  void start_afresh() override { particles_.forget_neighbours(); }
  void restore(const Cloud& state) override { particles_.restore(state); }
  double longest_step(double time, double courant) override;
  std::vector<StepLimit> step_limits() override { return {}; }

  std::vector<Conserved> conserved() const override;
  std::vector<Reading> readings() const override;
  std::vector<std::string> warnings() const override { return particles_.removed().warnings(); }
  PairWork pair_work() const override { return work_; }
  std::vector<std::string> remarks() const override;
  Parameters parameters() const override;
  std::span<const Body> bodies() const override { return particles_.start().bodies; }
  double spacing() const override { return particles_.start().spacing; }
  Triple force_on(std::size_t body) const override;

 private:
  using Line = PairLine<D>;
  using Vectors = std::vector<Vec<D>>;

  void refuse_what_does_not_go_together() const;
  void find_full_neighbourhood();
  double lattice_kernel_density() const;
  void refuse_broken_arrangement();
  void find_full_laplacian();
  void choose_solver();
  void find_surroundings(double time, double travel);
  void take_positions(double time, double travel);
  void fill_points();
  void find_weights();
  void free_surface_of_stress();
  std::span<const double> pressure_laplacian(Index i) const;
  void make_pattern();
  void find_surface();
  double pressure_half_a_spacing_down(Index i) const;
  Vec<D> outward(Index i) const;
  bool has_empty_cone(Index i) const;
  bool has_fixed_pressure(Index i) const {
    return at_surface_[static_cast<std::size_t>(i)] != 0 &&
           options_.surface_test != SurfaceTest::missing_neighbours;
  }
  double number_density(Index i) const;
  double least_spread(Index i) const;
  double kernel_density(Index i) const;

  void predict(double step);
  void show(const Vectors& velocities);
  void show_velocities();
  void show_pressure();
  void extrapolate_to(Index i);
  Vec<D> laplacian_of_velocity(Index i) const;
  Vec<D> gradient_of_pressure(Index i) const;

  void project(double step);
  void assemble(double step);
  void refuse_bad_diagonals() const;
  double source_at(Index i, double step) const;
  void solve();
  void collide();
  Vec<D> bounce(Index i, Index j) const;
  Vec<D> bounce_off_walls(Index i) const;
  void shift_particles(double time, double step);

  void expect_densities_after(double step);
  template <class Term>
  double sum_over_fluid(Term term) const;
  const Vec<D>& gravity() const { return body_force_.gravity(); }
  double highest_speed() const;
  double highest_wall_speed(double time) const;
  void find_pulls(double time);
  void note_fields();

  IncompressibleOptions options_;
  FlowParticles<D> particles_;
  std::unique_ptr<FluidTerms<D>> terms_;
  std::unique_ptr<DifferentialOperator<D>> operator_;
  std::unique_ptr<DifferentialOperator<D>> pressure_operator_;  ///< null: the same
  double smoothing_length_, volume_, mass_;
  BodyForce<D> body_force_;
  Vectors pulls_;  ///< gravity and force at every particle, now

  Points<D> points_;  ///< as the operator sees the lines
  PairWeights<D> weights_;
  std::vector<double> pressure_weights_;  ///< l_ij of the pressure's own operator, by pair
  double full_laplacian_ = 0;             ///< sum of l_ij of a lattice
  double full_number_density_ = 0, full_kernel_density_ = 0;  ///< n0, of the lattice
  std::vector<double> density_;                               ///< relative to that of the lattice
  std::vector<double> expected_density_;  ///< where v and gravity alone would take the particles
  std::vector<std::uint8_t> at_surface_;
  std::vector<std::uint8_t> alone_;       ///< with too few neighbours for any derivative
  std::vector<double> surface_pressure_;  ///< at the particles of the surface
  std::vector<double> trust_;             ///< in the pressure's gradient: 1, or less at the surface

  Vectors velocity_;                 ///< v, while a step is under way
  std::vector<std::uint8_t> moves_;  ///< whether shifting moves a particle
  std::vector<double> before_;       ///< divergence of the velocity before the kick
  std::unique_ptr<LinearSolver> solver_;
  NeighbourLists columns_;  ///< of the matrix, but for its diagonal
  SparseMatrix matrix_;
  std::vector<Index> slot_;             ///< where in its row the entry of a pair is
  std::int64_t pattern_of_ = -1;        ///< for which lists the pattern was made
  std::int64_t prepared_for_ = -1;      ///< the numbering that the preconditioner was made for
  std::int64_t enough_iterations_ = 0;  ///< beyond which it is not worth keeping
  std::vector<double> right_side_, pressure_;

  PairWork work_;

  /// What the run came to.
  struct Course {
    SolveResult last;
    std::int64_t steps = 0, iterations = 0, collisions = 0;
    double solving = 0, stepping = 0;  ///< seconds
    double volume_error = 0;           ///< mean of the relative densities, less 1
    double divergence = 0;             ///< root mean square, before the last kick
  } course_;
};

extern template class Incompressible<2>;
extern template class Incompressible<3>;

}  // namespace mote
