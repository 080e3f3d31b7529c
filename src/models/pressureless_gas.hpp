#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "mote/models/model.hpp"
#include "mote/neighbours/line.hpp"
#include "mote/particles/extension.hpp"

namespace mote {

enum class GravityForm { sheets, potential };
enum class DensityForm { automatic, mass_over_volume, continuity };
enum class FrameChoice { automatic, lagrangian, eulerian };

/// Options of the pressureless gas; see `describe` for their meaning.
struct PressurelessGasOptions {
  double gravity = 0;
  double viscosity = 0;
  GravityForm gravity_form = GravityForm::sheets;
  DensityForm density = DensityForm::automatic;
  FrameChoice frame = FrameChoice::automatic;

  void describe(Description& description);
};

/// Pressureless, self-gravitating gas on a line (Isshiki 2014, (72), (73), (81)):
///   Lagrangian:  Dx/Dt = u,   Du/Dt = -Pi' + nu u'',         D rho/Dt = -rho u'  or  rho = m/dx
///   Eulerian:    du/dt = -u u' - Pi' + nu u'',               d rho/dt = -(rho u)'
/// with Pi'' = 4 pi G rho. Primes are the scenario's operator, except that gravity by `sheets`
/// takes Pi' from the mass on either side of each particle, which is exact on a line.
///
/// Every particle is a cell of gas between two edges. The edges fall like the particles: in the
/// gravity of the sheets the length of cell i obeys  d^2(dx_i)/dt^2 = -4 pi G m_i  (the difference
/// of (73b) over the cell), and under all other forces each edge moves with the mean of its two
/// particles, which is (74a). So mass over volume is exact as long as the motion is.
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

  void update_dependent_fields() override;
  void inspect() const override;
  std::vector<Conserved> conserved() const override;
  StepLimit step_limit() const override;
  PairWork pair_work() const override { return work_; }
  std::vector<std::string> remarks() const override;
  Parameters parameters() const override;

 private:
  void fill_cloud(const LineSetup& setup);
  void name_evolving_values();
  bool uses_operator() const;
  bool uses_edges() const { return frame_ == Frame::lagrangian; }
  void add_gravity_of_potential();
  void add_viscosity();
  void add_advection();
  void update_edge_rates();
  std::span<const double> extended(std::span<const double> values, std::vector<double>& room);

  PressurelessGasOptions options_;
  Frame frame_;
  bool continuity_;
  std::unique_ptr<DifferentialOperator<1>> operator_;
  LineExtension extension_;
  double lower_;
  Cloud cloud_;
  std::span<double> position_, velocity_, density_, mass_, length_, length_rate_;

  std::vector<double> acceleration_, operator_acceleration_, length_acceleration_, density_rate_;
  std::vector<Evolving> drifted_, kicked_;

  LineSearch search_;
  NeighbourLists lists_;
  Points<1> points_;
  std::vector<double> field_, derivative_, mass_below_, moment_below_;
  PairWork work_;
};

/// `type: pressureless_gas` in a scenario.
class PressurelessGasRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "pressureless_gas";
  static constexpr std::string_view summary =
      "self-gravitating gas without pressure on a line, (72), (73), (81)";

  PressurelessGasOptions options;

  void describe(Description& description) override { options.describe(description); }
  std::vector<InitialField> initial_fields() const override;
  std::unique_ptr<Model> make(LineSetup setup) const override;
  std::vector<std::string> conserved_names() const override {
    return {"mass", "momentum", "energy"};
  }
};

}  // namespace mote
