#include "mote/integrators/conservation_correction.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace mote {
namespace {

using Eigen::Vector3d;

/// The motion of the second body relative to the first, in three dimensions.
class TwoBodies {
 public:
  explicit TwoBodies(System& system)
      : dimension_(system.dimension()),
        masses_(*system.point_masses()),
        place_(system.drifted().front().value),
        velocity_(system.kicked().front().value) {}

  Vector3d separation() const { return difference(place_); }
  Vector3d velocity() const { return difference(velocity_); }

  double potential() const {
    const double pull = masses_.gravitational_constant * total_mass();
    const double distance = separation().norm();
    return dimension_ == 2 ? pull * std::log(distance) : -pull / distance;
  }

  /// Changes the relative velocity, and not that of the centre of mass.
  void change_velocity(const Vector3d& change) {
    for (int d = 0; d < dimension_; ++d) {
      velocity_[d] -= masses_.mass[1] / total_mass() * change[d];
      velocity_[dimension_ + d] += masses_.mass[0] / total_mass() * change[d];
    }
  }

 private:
  double total_mass() const { return masses_.mass[0] + masses_.mass[1]; }

  Vector3d difference(std::span<const double> vectors) const {
    Vector3d result = Vector3d::Zero();
    for (int d = 0; d < dimension_; ++d) result[d] = vectors[dimension_ + d] - vectors[d];
    return result;
  }

  int dimension_;
  PointMasses masses_;
  std::span<double> place_, velocity_;
};

}  // namespace

std::string ConservationCorrection::missing_in(System& system) {
  const auto masses = system.point_masses();
  const bool two = masses && masses->mass.size() == 2 && masses->mass[0] + masses->mass[1] > 0;
  return two ? "" : "two point masses, for its conservation correction";
}

void ConservationCorrection::see(System& system) {
  if (kept_) return;
  const TwoBodies bodies(system);
  const Vector3d velocity = bodies.velocity();
  kept_ = {velocity.squaredNorm() / 2 + bodies.potential(), bodies.separation().cross(velocity)};
}

void ConservationCorrection::correct(System& system) const {
  TwoBodies bodies(system);
  const Vector3d r = bodies.separation(), found = bodies.velocity(), L = kept_->angular_momentum;
  const double energy = kept_->energy, potential = bodies.potential();
  const double square = 2 * r.squaredNorm() * (energy - potential) - L.squaredNorm();
  const double terms =
      2 * r.squaredNorm() * (std::abs(energy) + std::abs(potential)) + L.squaredNorm();
  double radial = r.dot(found);
  if (std::abs(square - radial * radial) > 8 * std::numeric_limits<double>::epsilon() * terms)
    radial = std::copysign(std::sqrt(std::max(square, 0.0)), radial);
  bodies.change_velocity((L.cross(r) + radial * r) / r.squaredNorm() - found);
}

std::vector<double> ConservationCorrection::memory() const {
  if (!kept_) return {};
  const Vector3d& L = kept_->angular_momentum;
  return {kept_->energy, L.x(), L.y(), L.z()};
}

void ConservationCorrection::recall(std::span<const double> memory) {
  kept_.reset();
  if (!memory.empty()) kept_ = {memory[0], {memory[1], memory[2], memory[3]}};
}

}  // namespace mote
