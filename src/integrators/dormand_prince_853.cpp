#include "mote/integrators/dormand_prince_853.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "mote/integrators/dormand_prince_853_tableau.hpp"
#include "mote/integrators/relative_error.hpp"

namespace mote {
namespace {

using namespace dormand_prince_853;

constexpr auto error_3 = [] {
  std::array<double, stages> error{};
  for (std::size_t s = 0; s < stages; ++s) error[s] = weight[s] - weight_3[s];
  return error;
}();

/// Weights of the stages' rates after part p of a step, y(p) = y(0) + step * sum_s w_s(p) k_s. With
/// q = 1 - p, m = sum_s weight_s k_s, k_0 and k_12 the rates at the ends, and d_j the sums with the
/// rows of `path`:
///   p (m + q (k_0 - m + p (2 m - k_0 - k_12 + q (d_0 + p (d_1 + q (d_2 + p d_3)))))).
std::array<double, stages_with_path> path_weights(double p) {
  const double q = 1 - p;
  const auto rate_at = [](std::size_t end, std::size_t s) { return s == end ? 1.0 : 0.0; };
  std::array<double, stages_with_path> result{};
  for (std::size_t s = 0; s < stages_with_path; ++s) {
    const double high = path[0][s] + p * (path[1][s] + q * (path[2][s] + p * path[3][s]));
    const double start = rate_at(0, s), end = rate_at(stages, s), mean = weight[s];
    result[s] = p * (mean + q * (start - mean + p * (2 * mean - start - end + q * high)));
  }
  return result;
}

}  // namespace

bool DormandPrince853::start(System& system, double time) {
  time_ = time;
  stages_.start(system, stages_with_path);
  return evaluate(system, 0);
}

double DormandPrince853::try_step(System& system, double time, double step) {
  time_ = time;
  step_ = step;
  for (std::size_t stage = 1; stage < stages; ++stage) {
    stages_.go_to(matrix[stage], step);
    if (!evaluate(system, stage)) return std::numeric_limits<double>::infinity();
  }
  stages_.go_to(weight, step);
  return estimated_error();
}

void DormandPrince853::finish(System& system, double step) {
  stages_.return_to_start();
  drift(system, stages_.drifted.combined(weight), step);
  kick(system, stages_.kicked.combined(weight), step);
  path_is_prepared_ = false;
}

void DormandPrince853::go_along_path(System& system, double part) {
  if (!path_is_prepared_) prepare_path(system);
  stages_.go_to(path_weights(part), step_);
  if (part != 1) return;
  drifted_at_end_.restore(system.drifted());  // to the bit
  kicked_at_end_.restore(system.kicked());
}

bool DormandPrince853::evaluate(System& system, std::size_t stage) {
  stages_.evaluate(system, time_ + node[stage] * step_, stage);
  return stages_.is_finite(stage);
}

/// e_5^2 / sqrt(e_5^2 + e_3^2/100), e_p the difference to the method of order p: it goes with the
/// power 8 of the step.
double DormandPrince853::estimated_error() {
  const double fifth = relative_error(stages_, error_5, step_);
  const double third = relative_error(stages_, error_3, step_);
  return fifth > 0 ? fifth * (fifth / std::hypot(fifth, third / 10)) : fifth;
}

void DormandPrince853::prepare_path(System& system) {
  drifted_at_end_.keep(system.drifted());
  kicked_at_end_.keep(system.kicked());
  evaluate(system, stages);
  for (std::size_t stage = stages + 1; stage < stages_with_path; ++stage) {
    stages_.go_to(matrix[stage], step_);
    evaluate(system, stage);
  }
  path_is_prepared_ = true;
}

}  // namespace mote
