#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "mote/models/line_diffusion.hpp"
#include "mote/models/model.hpp"
#include "mote/neighbours/line.hpp"

namespace mote {

enum class GravityForm { sheets, potential };
enum class DensityForm { automatic, mass_over_volume, continuity };
enum class FrameChoice { automatic, lagrangian, eulerian };
enum class ViscosityScheme { implicit, substepped, explicit_rates };

/// Options of the pressureless gas; see `describe` for their meaning.
struct PressurelessGasOptions {
  double gravity = 0;
  double viscosity = 0;
  GravityForm gravity_form = GravityForm::sheets;
  DensityForm density = DensityForm::automatic;
  FrameChoice frame = FrameChoice::automatic;
  ViscosityScheme viscosity_scheme = ViscosityScheme::implicit;
  double artificial_viscosity = 0;  ///< mu of (82), a step [length^2]
  bool smoothed_density = false;    ///< whether (86) is applied at the start

  void describe(Description& description);
};

/// Pressureless, self-gravitating gas on a line (Isshiki 2014, (72), (73), (81)):
///   Lagrangian:  Dx/Dt = u,   Du/Dt = -Pi' + nu u'',         D rho/Dt = -rho u'  or  rho = m/dx
///   Eulerian:    du/dt = -u u' - Pi' + nu u'',               d rho/dt = -(rho u)'
/// with Pi'' = 4 pi G rho. Primes are the scenario's operator, except that gravity by `sheets`
/// takes Pi' from the mass on either side of each particle, which is exact on a line.
///
/// Every particle is a cell of gas between two edges, and each edge moves with the mean of its two
/// particles, which is (74a). Where the gravity of the sheets is the only force, the edges fall
/// like the particles instead: the length of cell i obeys  d^2(dx_i)/dt^2 = -4 pi G m_i  (the
/// difference of (73b) over the cell). So mass over volume is exact as long as the motion is.
///
/// The viscosity acts in half steps before and after each step of the integrator, while the points
/// stand still, or, explicitly, as a rate among the others.
class PressurelessGas final : public Model {
 public:
  PressurelessGas(const PressurelessGasOptions& options, LineSetup setup);

  Cloud& cloud() override { return cloud_; }
  const Cloud& cloud() const override { return cloud_; }
  Frame frame() const override { return frame_; }

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return !continuity_; }
  void prepare(double time) override;
  void update_drift_rates(double time) override;
  void update_kick_rates(double time) override;

  void begin_step(double time, double step) override;
  void end_step(double time, double step) override;
  void update_dependent_fields() override;
  void inspect() const override;
  std::vector<Conserved> conserved() const override;
  std::vector<StepLimit> step_limits() override;
  std::vector<std::string> warnings() const override;
  PairWork pair_work() const override { return work_; }
  std::vector<std::string> remarks() const override;
  Parameters parameters() const override;

 private:
  void fill_cloud(const LineSetup& setup);
  void smooth_density();
  void make_room();
  void refuse_what_does_not_go_together(const LineSetup& setup) const;

  bool is_explicit() const;
  bool rates_use_operator() const;
  bool uses_operator() const { return rates_use_operator() || options_.viscosity > 0; }
  bool has_edges() const { return frame_ == Frame::lagrangian; }
  bool edges_fall_freely() const;

  void prepare_operator();
  void add_gravity_of_potential();
  void add_viscosity();
  void add_advection();
  void update_length_rates();
  void hold_ends(std::span<double> rates) const;
  std::span<const double> extended(std::span<const double> values, Parity parity);

  void add_viscosity_over(double time);
  void add_artificial_viscosity();
  void note_step_limit(double time, double step);
  double explicit_limit();
  std::string cause_of_crossing() const;
  std::vector<std::string> remarks_on_viscosity() const;

  PressurelessGasOptions options_;
  Frame frame_;
  bool continuity_;
  std::unique_ptr<DifferentialOperator<1>> operator_;
  LineExtension extension_;
  double lower_, upper_;
  Cloud cloud_;
  std::span<double> position_, velocity_, density_, mass_, length_, length_rate_;

  std::vector<double> acceleration_, operator_acceleration_, length_acceleration_, density_rate_;
  std::vector<Evolving> drifted_, kicked_;

  LineSearch search_;
  NeighbourLists lists_;
  Points<1> points_, fresh_points_;
  std::vector<double> field_, derivative_, mass_below_, moment_below_;
  PairWork work_;

  LineDiffusion diffusion_;
  bool diffusion_is_current_ = false;  ///< assembled for the points as they are
  std::string smoothing_;              ///< what (86) did at the start

  /// What the steps so far came to, for the report.
  struct Course {
    std::int64_t steps = 0, substeps = 0, most_substeps = 0;
    double step = 0;                            ///< the last one
    double passed_at = 0, passed_limit = 0;     ///< when a step first passed the explicit limit
    double velocity_moved = 0, mass_moved = 0;  ///< sums of |change| dx by (82)
    bool passed() const { return passed_limit > 0; }
  } course_;
};

/// `type: pressureless_gas` in a scenario.
class PressurelessGasRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "pressureless_gas";
  static constexpr std::string_view summary =
      "self-gravitating gas without pressure on a line, (72), (73), (81)";

  PressurelessGasOptions options;

  void describe(Description& description) override { options.describe(description); }
  std::vector<InitialField> initial_fields(int dimension) const override;
  using ModelRecipe::make;
  std::unique_ptr<Model> make(LineSetup setup) const override;
  std::unique_ptr<Model> make_reference(LineSetup setup) const override;
  std::vector<std::string> conserved_names(int /*dimension*/) const override {
    return {"mass", "momentum", "energy"};
  }
};

}  // namespace mote
