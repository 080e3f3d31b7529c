#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// A ball of matter of uniform density that starts at rest.
struct ColdBall {
  double gravitational_constant = 1, mass = 1, radius = 1;
  std::array<double, 3> centre{}, velocity{};  ///< of its centre of mass, at the start
  std::vector<double> position;                ///< of the bodies that sample it: 3 numbers each
};

/// Its collapse under its own gravity: every shell falls by r'' = -G m(r)/r^2 with the mass within
/// it, so all keep r = r_0 f(t) with f'' = -G M/(R^3 f^2), f(0) = 1, f'(0) = 0. The first integral
/// f'^2 = 2 G M/R^3 (1/f - 1) and f = cos^2 beta give
///   beta + sin(2 beta)/2 = t sqrt(2 G M/R^3),
/// which ends at beta = pi/2. (Lin, Mestel & Shu 1965, for their sphere)
class HomologousCollapse final : public FlowSolution {
 public:
  static constexpr std::string_view name = "cold_collapse";
  static constexpr std::string_view summary =
      "a uniform ball at rest that falls together under its own gravity";

  explicit HomologousCollapse(ColdBall ball);

  std::string statement() const override;
  double valid_until() const override;
  Table at_places(std::span<const double> position, int dimension, double time) const override;
  bool knows_particles() const override { return true; }
  Table of_particles(double time) const override;

  /// Radius over that at the start. Throws std::domain_error beyond `valid_until`.
  double contraction(double time) const;
  /// Its rate of change. [1/time]
  double contraction_rate(double time) const;

 private:
  double beta(double time) const;

  ColdBall ball_;
  double rate_;  ///< sqrt(2 G M/R^3)
};

}  // namespace mote
