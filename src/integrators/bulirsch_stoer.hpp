#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mote/integrators/extrapolation.hpp"
#include "mote/integrators/integrator.hpp"
#include "mote/integrators/stoermer_rule.hpp"

namespace mote {

/// Extrapolation of Stoermer's rule for equations of second order without velocities, with control
/// of step and order as in the code ODEX2 (Hairer, Norsett & Wanner 1993, II.9 and II.14): results
/// with 2, 4, 6, ... steps, k of which give order 2k, until the error of the last but one is below
/// the tolerance. As in ODEX2, it is the better last one that goes on. A path of the order of the
/// step comes from the same accelerations.
class BulirschStoer final : public Integrator {
 public:
  static constexpr std::string_view name = "bulirsch_stoer";
  static constexpr std::string_view summary =
      "extrapolation of Stoermer's rule, order up to 18 and steps by the error, like ODEX2; order "
      "12 for steps of given length";
  static constexpr int order = 12;  ///< of steps of given length
  static constexpr double default_tolerance = 1e-14;

  std::string missing_in(System& system) const override;
  void advance_one_step(System& system, double time, double step) override;

  /// A step that `longest` cuts short leaves the method's own idea of the next one as it was.
  /// Throws NumericalFailure where no step however short keeps the tolerance.
  double advance(System& system, double time, double longest) override;
  bool chooses_steps() const override { return true; }
  /// Throws InputError for an error that is not above 0.
  void tolerate(double error) override;

  /// The first call in a step evaluates the accelerations at its end.
  bool has_path() const override { return true; }
  void go_along_path(System& system, double part) override;

  /// The proposal for the next step.
  std::vector<double> memory() const override;
  /// Throws InputError for a memory that is not of this method.
  void recall(std::span<const double> memory) override;

 private:
  static constexpr int most_results = 9;

  /// What the next step is to be: its length, and how many results are thought to be enough.
  struct Proposal {
    double step = 0;
    int results = 0;
  };

  void begin(double step);
  void add_result(System& system);
  void finish(System& system);

  Proposal first_proposal() const;
  bool converges(System& system, const Proposal& tried);
  double error(System& system) const;
  Proposal after_failure(const Proposal& tried) const;
  Proposal after_success(bool at_once) const;

  double tolerance_ = default_tolerance;
  std::optional<Proposal> proposal_;

  FallingState start_, end_;
  double step_ = 0;
  std::vector<StoermerResult> results_;
  Extrapolation changes_;                                   ///< of places, then velocities
  std::array<double, most_results + 1> length_{}, work_{};  ///< by number of results
  std::optional<ExtrapolatedPath> path_;
};

}  // namespace mote
