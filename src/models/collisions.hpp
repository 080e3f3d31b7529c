#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mote/particles/vector.hpp"

namespace mote {

/// Two bodies that came into contact.
struct Collision {
  double time = 0;
  std::size_t first = 0, second = 0;  ///< their numbers
  double speed = 0;                   ///< of the one relative to the other
};

/// Places and velocities at one end of a step, D numbers a body.
struct StepEnd {
  std::span<const double> position, velocity;
};

/// How two bodies lie to each other within a step: the cubic through separation and relative
/// velocity at its ends (Hermite), off by O(step^4), in Bezier's form.
template <int D>
class Approach {
 public:
  /// Separations, and relative velocities times the step, at the start and at the end.
  Approach(const std::array<Vec<D>, 2>& separation, const std::array<Vec<D>, 2>& change);

  /// The part of the step after which they are as close as this; nothing if they never are. At the
  /// start they must be further apart.
  std::optional<double> first_within(double distance) const;

  /// Rate at which the separation changes, per step.
  Vec<D> rate(double part) const;

 private:
  std::array<Vec<D>, 4> control_;
};

/// Watches balls for contacts, not at the ends of steps alone. Nothing happens to them: what has
/// been in contact goes on, and collides again only once it has been apart at the end of a step.
template <int D>
class Collisions {
 public:
  /// Radii by body, from the first on; one without a radius never collides.
  explicit Collisions(const std::vector<std::optional<double>>& radius);

  bool exist() const { return balls_.size() > 1; }

  /// Two bodies that are in contact, if there are any.
  std::optional<std::array<std::size_t, 2>> contact(std::span<const double> position) const;

  void begin_step(const StepEnd& start);
  /// Contacts that began in the step since `begin_step`, from `time` on, in the order of time.
  std::vector<Collision> end_step(double time, double step, const StepEnd& end) const;

 private:
  struct Ball {
    std::size_t body;
    double radius;
  };
  std::vector<Ball> balls_;
  std::vector<double> position_, velocity_;  ///< at the start of the step
};

extern template class Approach<2>;
extern template class Approach<3>;
extern template class Collisions<2>;
extern template class Collisions<3>;

}  // namespace mote
