#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mote/integrators/gauss_radau_tables.hpp"
#include "mote/integrators/integrator.hpp"
#include "mote/integrators/packs.hpp"

namespace mote {

/// Everhart's implicit method of order 15 with Gauss-Radau nodes (in: Dynamics of Comets, 1985,
/// 185), for x'' = f(t, x), to the limit of rounding as in Rein & Spiegel (2015, MNRAS 446, 1424):
/// compensated summation of places and velocities, and a prediction of the accelerations from those
/// of the last step. The length of a step is that of Pham, Rein & Spiegel (2024, Open J. Astrophys.
/// 7, eqs. 14 to 16), but where an acceleration passes through 0: a part of the shortest time in
/// which one changes, by its derivatives.
///
/// The accelerations at the nodes are found in sweeps over the nodes, until what a further sweep
/// would change is next to nothing: judged by how much smaller each correction is than the last
/// one, and not by the further sweep itself.
class GaussRadau15 final : public Integrator {
 public:
  static constexpr std::string_view name = "gauss_radau_15";
  static constexpr std::string_view summary =
      "order 15 to the limit of rounding, chooses its steps, for accelerations of places alone";
  static constexpr int order = 15;

  /// Of the acceleration, by which the last term of its series over a step may change it: epsilon
  /// in the papers. Steps grow as its seventh root, and sweeps end where a further one would change
  /// 3e-8 of it. At the default an orbit errs by rounding for a thousand periods; at 1e-9, the
  /// papers' choice, for long after; up to 1e-6 errors grow slowly.
  static constexpr double default_tolerance = 1e-8;

  std::string missing_in(System& system) const override;
  void advance_one_step(System& system, double time, double step) override;
  double advance(System& system, double time, double longest) override;

  bool chooses_steps() const override { return true; }
  void tolerate(double error) override { tolerance_ = error; }

  /// By the polynomials of the last step; part 1 leads back to the very values of its end.
  bool has_path() const override { return true; }
  void go_along_path(System& system, double part) override;

  /// All of it: also what rounding lost, and the path.
  std::vector<double> memory() const override;
  void recall(std::span<const double> memory) override;

 private:
  /// Of one pack of numbers, what belongs to each node.
  using Nodes = std::vector<std::array<Pack, gauss_radau::nodes>>;

  void start(System& system, double time);
  void resize(std::size_t count);
  double first_step(double longest) const;
  void predict(double step);
  bool sweep_until_converged(System& system, double time, double step);
  double sweep(System& system, double time, double step);
  template <std::size_t Node>
  void evaluate(System& system, double time, double step);
  template <std::size_t Node>
  Pack correct();
  double time_of_change(double step);
  void accept(System& system, double step);
  template <class Visit>
  static void visit_memory(auto& method, Visit visit);

  double tolerance_ = default_tolerance;
  std::size_t count_ = 0;                    ///< of the numbers that are places
  std::size_t dimension_ = 0;                ///< how many of them are one body's
  double last_step_ = 0, next_step_ = 0;     ///< 0 before the first
  double predictions_ = 0;                   ///< steps since the first, up to 2
  PackedColumn place_, velocity_;            ///< at the end of the last step
  PackedColumn lost_place_, lost_velocity_;  ///< what rounding added to them
  PackedColumn start_place_, start_velocity_,
      start_;        ///< of the last step: places, velocities, rates
  Nodes change_;     ///< of the acceleration from the start of the last step to its nodes
  Nodes predicted_;  ///< the same as the step before it foretold

  PackedColumn rate_, moved_, jerk_, snap_, crackle_;  ///< work
  Nodes next_, foretold_;                              ///< of the step that is being taken
};

}  // namespace mote
