#pragma once

#include <string_view>
#include <vector>

#include "mote/integrators/embedded_pair.hpp"
#include "mote/integrators/kept_values.hpp"
#include "mote/integrators/stages.hpp"

namespace mote {

/// Dormand and Prince's Runge-Kutta method of order 8 with embedded methods of orders 5 and 3 and
/// dense output of order 7 (Hairer, Norsett and Wanner 1993, section II.10), all parts at once.
class DormandPrince853 final : public EmbeddedPair {
 public:
  static constexpr std::string_view name = "dormand_prince_853";
  static constexpr std::string_view summary =
      "order 8, chooses its steps, twelve evaluations a step; a path of order 7";
  static constexpr int order = 8;
  static constexpr double default_tolerance = 1e-10;

  DormandPrince853() : EmbeddedPair(name, default_tolerance, 8) {}

  /// The path takes four more evaluations when it is first asked for after a step, while the system
  /// still is where that step left it.
  bool has_path() const override { return true; }
  void go_along_path(System& system, double part) override;

 protected:
  bool start(System& system, double time) override;
  double try_step(System& system, double time, double step) override;
  void finish(System& system, double step) override;

 private:
  bool evaluate(System& system, std::size_t stage);
  double estimated_error();
  void prepare_path(System& system);

  Stages stages_;
  KeptValues drifted_at_end_, kicked_at_end_;
  double time_ = 0, step_ = 0;  ///< of the step that is tried, or was finished last
  bool path_is_prepared_ = false;
};

}  // namespace mote
