#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// u = A (x - c) + b, in `dimension` dimensions; what is beyond them is 0. A centre c near the
/// points keeps the digits that A c would take from their velocities.
struct LinearVelocity {
  int dimension = 2;
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), at_centre = Eigen::Vector3d::Zero();
};

/// Material points in a steady linear flow: x = x0 + Q(t) (A (x0 - c) + b), Q the integral of
/// e^(t A).
class LinearFlow final : public FlowSolution {
 public:
  static constexpr std::string_view name = "linear_flow";
  static constexpr std::string_view summary =
      "tracers in a steady velocity that is linear in space: rotation, shear, strain";

  /// `position` has `dimension` numbers a point.
  LinearFlow(const LinearVelocity& velocity, std::vector<double> position);

  std::string statement() const override;
  Table at_places(std::span<const double> position, int dimension, double time) const override;
  bool knows_particles() const override { return true; }
  Table of_particles(double time) const override;

 private:
  FlowState state_at(const std::array<double, 3>& place) const;

  LinearVelocity velocity_;
  std::vector<double> start_;
};

/// A material point that circles, at the radius and with the angular velocity of its start.
struct CirclingPoint {
  double radius = 0, angle = 0, angular_velocity = 0;
};

/// Material points in a steady vortex in the plane, whose angular velocity depends on the radius
/// alone: every one circles about the centre.
class CircularFlow final : public FlowSolution {
 public:
  static constexpr std::string_view name = "circular_flow";
  static constexpr std::string_view summary =
      "tracers in a steady vortex in the plane: all circle about its centre";

  CircularFlow(const std::array<double, 2>& centre, std::vector<CirclingPoint> points);

  std::string statement() const override;
  /// With the angular velocity of the points, between their radii linearly.
  Table at_places(std::span<const double> position, int dimension, double time) const override;
  bool knows_particles() const override { return true; }
  Table of_particles(double time) const override;

 private:
  double angular_velocity(double radius) const;

  std::array<double, 2> centre_;
  std::vector<CirclingPoint> points_;
  std::vector<CirclingPoint> by_radius_;
};

}  // namespace mote
