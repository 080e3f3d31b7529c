#pragma once

#include <string_view>
#include <vector>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// Places and velocities of particles at the start: what a periodic motion comes back to after
/// every period, and is away from at all other times.
class ReturnToStart final : public FlowSolution {
 public:
  static constexpr std::string_view name = "start";
  static constexpr std::string_view summary =
      "the state at the start, to which a periodic motion returns at its end";

  /// So many numbers a place, and a velocity.
  ReturnToStart(std::size_t dimension, std::vector<double> position, std::vector<double> velocity)
      : dimension_(dimension), position_(std::move(position)), velocity_(std::move(velocity)) {}

  std::string statement() const override {
    return "errors are the distances from the state at the start, so those of a motion with this "
           "period alone";
  }
  /// Throws std::logic_error: the motion is known by particle.
  Table at_places(std::span<const double> position, int dimension, double time) const override;
  bool knows_particles() const override { return true; }
  Table of_particles(double time) const override;

 private:
  std::size_t dimension_;
  std::vector<double> position_, velocity_;
};

}  // namespace mote
