#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "mote/models/model.hpp"

namespace mote::test {

/// Particles that swing about 0 and lose speed, x'' = -x - x': a model that decides on its steps,
/// predicts, and keeps its rates from one step to the next, which a restart does not know.
class DampedSwing final : public Model {
 public:
  DampedSwing(double collapse, const LineSetup& setup)
      : collapse_(collapse), cloud_(1, static_cast<Index>(setup.cells.centre.size())) {
    std::ranges::copy(setup.cells.centre, cloud_.position().begin());
    velocity_ = cloud_.add("velocity", FieldKind::vector, "m/s");
    for (std::size_t i = 0; i < velocity_.size(); ++i)
      velocity_[i] = setup.initial("velocity", cloud_.position()[i]);
    acceleration_.resize(velocity_.size());
    drifted_ = {{{cloud_.position(), velocity_}}};
    kicked_ = {{{velocity_, acceleration_}}};
  }

  Cloud& cloud() override { return cloud_; }
  const Cloud& cloud() const override { return cloud_; }
  Frame frame() const override { return Frame::lagrangian; }
  void update_dependent_fields() override {}
  void inspect() const override {}
  std::vector<Conserved> conserved() const override { return {{"count", 1.0 * cloud_.count(), 1}}; }
  std::vector<StepLimit> step_limits() override { return {}; }
  PairWork pair_work() const override { return {}; }
  std::vector<std::string> remarks() const override { return {}; }
  Parameters parameters() const override { return {}; }

  /// Shorter where the particles are faster, down to nothing at all with `collapse`.
  double longest_step(double, double courant) override {
    return 0.25 * courant / (1 + 10 * fastest()) - collapse_ * fastest();
  }
  void start_afresh() override { current_ = false; }
  std::vector<Reading> readings() const override { return {{"fastest", fastest()}}; }

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override { form_rates(0); }
  bool predicts() const override { return true; }
  void update_rates_ahead(double, double ahead) override { form_rates(ahead); }
  bool rates_are_current() const override { return current_; }
  bool compensates() const override { return false; }

 private:
  double fastest() const {
    double most = 0;
    for (const double v : velocity_) most = std::max(most, std::abs(v));
    return most;
  }
  void form_rates(double ahead) {
    for (std::size_t i = 0; i < velocity_.size(); ++i)
      acceleration_[i] = -cloud_.position()[i] - (velocity_[i] + ahead * acceleration_[i]);
    current_ = true;
  }

  double collapse_;
  Cloud cloud_;
  std::span<double> velocity_;
  std::vector<double> acceleration_;
  bool current_ = false;
  std::array<Evolving, 1> drifted_, kicked_;
};

/// `type: damped_swing` in a scenario.
class DampedSwingRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "damped_swing";
  static constexpr std::string_view summary = "swings about 0 and loses speed";

  void describe(Description& description) override {
    description.number({"collapse", "how soon the steps collapse"}, collapse_);
  }
  std::vector<InitialField> initial_fields(int) const override {
    return {{"velocity", "velocity at the start", "0"}};
  }
  std::vector<std::string> conserved_names(int) const override { return {"count"}; }
  using ModelRecipe::make;
  std::unique_ptr<Model> make(LineSetup setup) const override {
    return std::make_unique<DampedSwing>(collapse_, setup);
  }

 private:
  double collapse_ = 0;
};

}  // namespace mote::test
