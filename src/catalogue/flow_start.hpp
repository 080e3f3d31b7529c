#pragma once

#include <string>
#include <vector>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// What a flow in closed form needs to know of a start, measured. All throw InputError with the
/// key `check.against`, in the name of the solution.
class FlowStart {
 public:
  FlowStart(const FlowSetup& setup, std::string solution);

  [[noreturn]] void refuse(const std::string& problem) const;

  const SpaceStart& space() const { return setup_.start; }
  /// A parameter of the model; refuses models that do not have it.
  double parameter(const std::string& name) const;
  Triple gravity() const;
  /// Places of the fluid's particles, and what they start with.
  const std::vector<Triple>& fluid() const { return fluid_; }
  double initial(std::string_view field, const Triple& place) const;
  Triple velocity(const Triple& place) const;
  /// Lowest and highest coordinate of the fluid along an axis, to the edges of its cells.
  double lowest(std::size_t axis) const;
  double highest(std::size_t axis) const;

  void need_dimension(int dimension) const;
  void need_rest() const;
  void need_no_gravity() const;
  /// Refuses a start whose velocities at these places are not those of the solution; `refusal` says
  /// so, with {:.2g} for the largest difference relative to the largest velocity, if there is any.
  void need_velocities_of(const FlowSolution& solution, const std::vector<Triple>& places,
                          std::string_view refusal) const;

 private:
  double velocity_difference(const FlowSolution& solution, const std::vector<Triple>& places) const;

  const FlowSetup& setup_;
  std::string solution_;
  std::vector<Triple> fluid_;
};

/// Relative difference from a start in closed form that rounding and typed digits explain.
inline constexpr double same_start = 1e-6;

}  // namespace mote
