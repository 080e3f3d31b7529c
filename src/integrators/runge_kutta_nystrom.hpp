#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "mote/integrators/elementwise.hpp"
#include "mote/integrators/embedded_pair.hpp"
#include "mote/integrators/free_fall.hpp"
#include "mote/integrators/kept_values.hpp"
#include "mote/integrators/relative_error.hpp"
#include "mote/integrators/stages.hpp"

namespace mote {

/// Coefficients of an explicit pair of methods for x'' = f(t, x) (Nystrom 1925). With c the nodes,
/// a the matrix, b and b' the weights for places and velocities,
///   k_s = f(t + c_s h, x + c_s h v + h^2 sum_r a_sr k_r),
///   x(t + h) = x + h v + h^2 sum_s b_s k_s,   v(t + h) = v + h sum_s b'_s k_s.
template <std::size_t stages>
struct NystromTableau {
  using Weights = std::array<double, stages>;

  Weights node;
  std::array<Weights, stages> matrix;
  Weights place, velocity;
  Weights lower_place, lower_velocity;  ///< of the method that the error is measured by
};

/// The Runge-Kutta-Nystrom pair whose coefficients are `Method::tableau` and whose second method
/// is of order `lower_order`. For systems that fall freely.
template <class Method, int lower_order>
class RungeKuttaNystrom : public EmbeddedPair {
 public:
  RungeKuttaNystrom() : EmbeddedPair(Method::name, Method::default_tolerance, lower_order + 1) {}

  std::string missing_in(System& system) const final { return missing_for_free_fall(system); }

 protected:
  bool start(System& system, double time) final {
    drifted_ = system.drifted();
    places_.keep(drifted_);
    kicked_.start(system.kicked(), Method::tableau.node.size());
    shape_velocities();
    return evaluate(system, time, 0);
  }

  double try_step(System& system, double time, double step) final {
    const auto& tableau = Method::tableau;
    for (std::size_t stage = 1; stage < tableau.node.size(); ++stage) {
      const double node = tableau.node[stage];
      places_.go_on(velocities(node, tableau.matrix[stage], step), step);
      if (!evaluate(system, time + node * step, stage))
        return std::numeric_limits<double>::infinity();
    }
    places_.go_on(velocities(1, tableau.place, step), step);
    kicked_.go_to(tableau.velocity, step);
    return estimated_error(step);
  }

  void finish(System& system, double step) final {
    places_.restore(drifted_);
    kicked_.values_at_start().restore(kicked_.parts());
    drift(system, velocities(1, Method::tableau.place, step), step);
    kick(system, kicked_.combined(Method::tableau.velocity), step);
  }

 private:
  template <class Weights>
  static constexpr Weights difference(const Weights& a, const Weights& b) {
    Weights result{};
    for (std::size_t s = 0; s < a.size(); ++s) result[s] = a[s] - b[s];
    return result;
  }

  void shape_velocities() {
    velocity_.resize(drifted_.size());
    velocities_.clear();
    for (std::size_t part = 0; part < drifted_.size(); ++part) {
      velocity_[part].resize(drifted_[part].value.size());
      velocities_.push_back({drifted_[part].value, velocity_[part]});
    }
  }

  bool evaluate(System& system, double time, std::size_t stage) {
    system.prepare(time);
    system.update_kick_rates(time);
    kicked_.take(stage);
    return kicked_.is_finite(stage);
  }

  /// node v + h sum_s weight_s k_s, v the velocities at the start: the mean rate, over a step, of
  /// what drifts.
  std::span<const Evolving> velocities(double node, std::span<const double> weights, double step) {
    const auto sums = kicked_.combined(weights);
    for (std::size_t part = 0; part < sums.size(); ++part) {
      const auto start = kicked_.values_at_start().values(part), sum = sums[part].rate;
      const std::span<double> velocity = velocity_[part];
      for_each_element(start.size(),
                       [=](auto i) { velocity[i] = node * start[i] + step * sum[i]; });
    }
    return velocities_;
  }

  double estimated_error(double step) {
    constexpr auto place = difference(Method::tableau.place, Method::tableau.lower_place);
    constexpr auto velocity = difference(Method::tableau.velocity, Method::tableau.lower_velocity);
    return std::max(relative_error(places_, velocities(0, place, step), step),
                    relative_error(kicked_.values_at_start(), kicked_.combined(velocity), step));
  }

  std::span<const Evolving> drifted_;
  KeptValues places_;
  HalfStages kicked_;
  std::vector<std::vector<double>> velocity_;
  std::vector<Evolving> velocities_;
};

}  // namespace mote
