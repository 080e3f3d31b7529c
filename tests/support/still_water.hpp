#pragma once

#include <memory>
#include <utility>

#include "mote/models/model.hpp"

namespace mote::test {

/// A model in space with nothing in it but its initial fields.
class StillWaterRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "still_water";
  static constexpr std::string_view summary = "water that does nothing";

  void describe(Description&) override {}
  bool lives_on_a_line() const override { return false; }
  std::vector<InitialField> initial_fields(int) const override {
    return {{"pressure", "of the water", "0"}};
  }
  std::vector<std::string> conserved_names(int) const override { return {"mass"}; }
};

/// A tank of water with a bed, a lid that is dragged, and a stone.
inline const std::string tank = R"yaml(name: tank
dimension: 2
constants: {L: 2, U: 0.5}
domain:
  lower: [0, 0]
  upper: [L, 1]
  periodic: [x]
  walls:
    - {side: y_lower, name: bed, slip: free}
    - {side: y_upper, velocity: ["U*sin(t)", "0"]}
particles: {spacing: L/20, layout: jittered, seed: 3}
regions:
  - name: stone
    type: wall
    shapes: [{type: ball, centre: [L/2, 0.5], radius: 0.3}]
model: {type: still_water}
initial: {pressure: "1 - y"}
operator: {family: sph, kernel: wendland_c2, smoothing_length: 1}
neighbours: {search: kd_tree, skin: 0.1}
time: {end: 1}
)yaml";

}  // namespace mote::test
