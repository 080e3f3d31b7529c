#pragma once

#include <string_view>

#include "mote/integrators/hermite.hpp"
#include "mote/integrators/path.hpp"

namespace mote {

/// The Hermite polynomial through the last nodes (Rehman 2014, section 1.1), whose derivative is
/// the velocity: through places, velocities and, with two derivatives, accelerations at the ends of
/// the last `steps` steps, or of all there are until there are so many. It is used in the last of
/// these steps. At a node, it is the node's state to the bit.
class HermitePath : public Path {
 public:
  /// Evaluates the accelerations of a system that does not have them, where they are wanted. A node
  /// at the time of the last one is the last one again.
  void add_node(System& system, double time) override;
  void go_to(System& system, double time) const override;
  std::vector<double> memory() const override;
  /// Throws InputError for a memory that is not of such a path.
  void recall(std::span<const double> memory) override;

 protected:
  HermitePath(int steps, int derivatives) : steps_(steps), derivatives_(derivatives) {}

 private:
  int steps_, derivatives_;
  std::vector<KnownNode> nodes_;  ///< places, velocities and, if wanted, accelerations
};

class CubicHermite final : public HermitePath {
 public:
  static constexpr std::string_view name = "cubic_hermite";
  static constexpr std::string_view summary = "degree 3: places and velocities of one step";
  static constexpr int degree = 3;
  CubicHermite() : HermitePath(1, 1) {}
};

class QuinticHermite final : public HermitePath {
 public:
  static constexpr std::string_view name = "quintic_hermite";
  static constexpr std::string_view summary = "degree 5: accelerations too";
  static constexpr int degree = 5;
  QuinticHermite() : HermitePath(1, 2) {}
};

class TwoStepHermite final : public HermitePath {
 public:
  static constexpr std::string_view name = "two_step_hermite";
  static constexpr std::string_view summary = "degree 8: the same of two steps";
  static constexpr int degree = 8;
  TwoStepHermite() : HermitePath(2, 2) {}
};

class ThreeStepHermite final : public HermitePath {
 public:
  static constexpr std::string_view name = "three_step_hermite";
  static constexpr std::string_view summary = "degree 11: the same of three steps";
  static constexpr int degree = 11;
  ThreeStepHermite() : HermitePath(3, 2) {}
};

}  // namespace mote
