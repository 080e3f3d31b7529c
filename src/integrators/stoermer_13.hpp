#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/rows.hpp"

namespace mote {

/// A sum of rows that keeps what rounding loses in every addition.
class LongRowSum {
 public:
  LongRowSum() = default;
  explicit LongRowSum(Row start) : sum_(std::move(start)), lost_(sum_.size()) {}

  void add(const Row& row);
  void add(const LongRowSum& other);

  /// factor (sum + correction).
  Row times(double factor, const Row& correction) const;

  /// The sum as two rows, one after the other.
  Row memory() const;
  void recall(Row sum, Row lost);

 private:
  Row sum_, lost_;
};

/// Stoermer's multistep method of order 13 for steps of one length, in summed form with backward
/// differences added from the highest to the lowest (Grazier et al. 1999; Hairer, Norsett & Wanner
/// 1993, III.10). With F_n = sum of f up to n, and S_n the sum of these,
///   x_n+1 = h^2 (S_n + sum_j=2..12 sigma_j nabla^(j-2) f_n),
///   v_n+1 = h (F_n+1 + sum_j=1..12 gamma_j nabla^(j-1) f_n+1),
/// so one evaluation a step. The first 11 steps are taken by `BulirschStoer` with an error far
/// below that of a step here.
///
/// A step of another length begins all this again, at a cost of 600 to 1100 evaluations; steps
/// that differ no more than the rounding of times are steps of one length. The method is stable for
/// steps that resolve the fastest motion well: from about 75 in a period on.
class Stoermer13 final : public Integrator {
 public:
  static constexpr std::string_view name = "stoermer_13";
  static constexpr std::string_view summary =
      "multistep, order 13, one evaluation a step; for steps of one length";
  static constexpr int order = 13;

  std::string missing_in(System& system) const override;
  void advance_one_step(System& system, double time, double step) override;

  bool wants_equal_steps() const override { return true; }

  /// The step's length, then backward differences and sums. (They hold what rounding lost too, so
  /// that a restart gives the same bits.)
  std::vector<double> memory() const override;
  /// Throws InputError for a memory that is not of this method.
  void recall(std::span<const double> memory) override;

 private:
  bool goes_on(double time, double step) const;
  void begin(System& system, double time, double step);
  void take_starting_step(System& system, double time);
  void take_summed_step(System& system, double time);
  void add_acceleration(System& system, double time);
  void begin_sums(System& system);

  double step_ = 0;
  std::vector<Row> difference_;  ///< nabla^0 f, nabla^1 f, ... of the last accelerations f
  LongRowSum first_, second_;    ///< F_n and S_n, once there are enough differences
};

/// Coefficients of multistep methods by backward differences, from their generating functions
/// (Hairer, Norsett & Wanner 1993, (III.1.12) and (III.10.14)), with L = -log(1 - t)/t:
/// gamma of 1/L (Adams, implicit), sigma of 1/(L^2 (1 - t)) (Stoermer), cowell of 1/L^2.
struct MultistepCoefficients {
  std::vector<double> gamma, sigma, cowell;
};
MultistepCoefficients multistep_coefficients(int count);

}  // namespace mote
