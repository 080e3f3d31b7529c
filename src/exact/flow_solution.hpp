#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mote/exact/exact_solution.hpp"

namespace mote {

/// A flow in two or three dimensions known in closed form, for the initial state that it was made
/// from. The numbers are in the units that its constants have.
class FlowSolution {
 public:
  virtual ~FlowSolution() = default;

  /// One sentence that says what the solution is exact for.
  virtual std::string statement() const = 0;

  /// The last time for which there is an answer; infinite if there is no last one.
  virtual double valid_until() const;

  /// The fields at places of `dimension` numbers each: velocity_x, velocity_y[, velocity_z], and
  /// pressure where it is known.
  virtual Table at_places(std::span<const double> position, int dimension, double time) const = 0;

  /// Whether the flow is known by particle too: places and velocities of those of the start, in
  /// their order, position_x, position_y, velocity_x, ... Without, `of_particles` throws
  /// std::logic_error.
  virtual bool knows_particles() const { return false; }
  virtual Table of_particles(double time) const;
};

/// A flow as the exact solution that a run in space is compared with, at the places of its
/// particles.
class FlowReference final : public ExactSolution {
 public:
  FlowReference(std::unique_ptr<FlowSolution> flow, int dimension)
      : flow_(std::move(flow)), dimension_(dimension) {}

  std::string statement() const override { return flow_->statement(); }
  double valid_until() const override { return flow_->valid_until(); }
  Table at_places(std::span<const double> position, double time) const override {
    return flow_->at_places(position, dimension_, time);
  }
  bool knows_particles() const override { return flow_->knows_particles(); }
  Table of_particles(double time) const override { return flow_->of_particles(time); }
  /// A flow has no curve along one line: of those known by particle, what `of_particles` says of at
  /// most 200 of them; else an empty table.
  Table curve(double time) const override;

 private:
  std::unique_ptr<FlowSolution> flow_;
  int dimension_;
};

/// Velocity and pressure at one place; in two dimensions the last component is 0.
struct FlowState {
  std::array<double, 3> velocity{};
  double pressure = 0;
};

enum class WithPressure { no, yes };

/// The table that `at_places` returns, of a function from a place to a FlowState.
template <class StateAt>
Table flow_table(std::span<const double> position, int dimension, WithPressure pressure,
                 StateAt state_at) {
  const auto components = static_cast<std::size_t>(dimension);
  Table table{{"velocity_x", {}}, {"velocity_y", {}}, {"velocity_z", {}}};
  table.resize(components);
  if (pressure == WithPressure::yes) table.push_back({"pressure", {}});
  for (std::size_t first = 0; first < position.size(); first += components) {
    std::array<double, 3> place{};
    for (std::size_t d = 0; d < components; ++d) place[d] = position[first + d];
    const FlowState state = state_at(place);
    for (std::size_t d = 0; d < components; ++d) table[d].values.push_back(state.velocity[d]);
    if (pressure == WithPressure::yes) table.back().values.push_back(state.pressure);
  }
  return table;
}

}  // namespace mote
