#include "mote/scenario/check_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "mote/particles/lattice.hpp"
#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

constexpr std::array keys_on_a_line{"domain.boundary", "domain.extension", "particles.count"};
constexpr std::array keys_in_space{"domain.periodic",  "domain.walls", "particles.spacing",
                                   "particles.jitter", "regions",      "neighbours.skin",
                                   "time.courant"};

/// Checks a scenario whose sections have been read.
class Check {
 public:
  Check(const Scenario& scenario, const Document& document)
      : scenario_(scenario), document_(document) {}

  void on_a_line() const {
    if (scenario_.dimension != 1)
      refuse("dimension",
             fmt::format("the model {} lives on a line: dimension must be 1, and is {}",
                         scenario_.model_type, scenario_.dimension));
    refuse_strangers(keys_in_space, "in space", "on a line");
    require("particles", "count");
    require("time", "step");
    const std::string& layout = scenario_.particles.layout;
    if (is_layout_in_space(layout))
      refuse_stranger("particles.layout", layout, "in space", "on a line");
    const std::string& search = scenario_.neighbours.search;
    if (search != "automatic" && search != "line")
      refuse_stranger("neighbours.search", search, "in space", "on a line");
  }

  void in_space() const {
    if (scenario_.dimension == 1)
      refuse("dimension",
             fmt::format("the model {} lives in space: dimension must be 2 or 3, and is 1",
                         scenario_.model_type));
    refuse_strangers(keys_on_a_line, "on a line", "in space");
    if (scenario_.model->needs_domain() || !scenario_.probes.empty())
      require("particles", "spacing");
    check_particles();
    check_sides();
    check_names();
    for (std::size_t k = 0; k < scenario_.domain.walls.size(); ++k)
      check_velocity(fmt::format("domain.walls.{}.velocity", k), scenario_.domain.walls[k]);
    for (std::size_t k = 0; k < scenario_.regions.size(); ++k) check_region(k);
  }

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const {
    throw LocatedError(document_.locate(key), message);
  }

  [[noreturn]] void refuse_stranger(const std::string& key, const std::string& word,
                                    const char* home, const char* here) const {
    refuse(key, fmt::format("'{}' belongs to models {}, and the model {} lives {}", word, home,
                            scenario_.model_type, here));
  }

  template <std::size_t N>
  void refuse_strangers(const std::array<const char*, N>& keys, const char* home,
                        const char* here) const {
    for (const char* key : keys)
      if (document_.find(keys_of(key)) != nullptr)
        refuse_stranger(key, keys_of(key).back(), home, here);
  }

  void require(const std::string& section, const std::string& key) const {
    if (document_.find({section, key}) == nullptr)
      refuse(section, fmt::format("section '{}' lacks the key '{}'", section, key));
  }

  static bool is_layout_in_space(const std::string& layout) {
    return std::ranges::find(lattice_layouts(), layout, &Choice::name) != lattice_layouts().end();
  }

  void check_particles() const {
    const auto& particles = scenario_.particles;
    if (!particles.layout.empty() && !is_layout_in_space(particles.layout))
      refuse_stranger("particles.layout", particles.layout, "on a line", "in space");
    if (particles.jitter && particles.layout != "jittered")
      refuse("particles.jitter", "'jitter' has a meaning for the layout 'jittered' alone");
    if (scenario_.neighbours.search == "line")
      refuse_stranger("neighbours.search", "line", "on a line", "in space");
  }

  /// Whether an axis that starts with this letter is one of the scenario's dimensions.
  bool has_axis(char letter) const { return letter - 'x' < scenario_.dimension; }

  void check_sides() const {
    const auto& periodic = scenario_.domain.periodic;
    const auto& walls = scenario_.domain.walls;
    std::set<std::string> seen;
    for (std::size_t k = 0; k < periodic.size(); ++k) {
      const std::string key = fmt::format("domain.periodic.{}", k);
      if (!has_axis(periodic[k].front()))
        refuse(key, fmt::format("there is no axis {} in {} dimensions", periodic[k],
                                scenario_.dimension));
      if (!seen.insert(periodic[k]).second)
        refuse(key, fmt::format("the axis {} is given twice", periodic[k]));
    }
    for (std::size_t k = 0; k < walls.size(); ++k) {
      const std::string& side = walls[k].side;
      const std::string key = fmt::format("domain.walls.{}.side", k);
      if (!has_axis(side.front()))
        refuse(key, fmt::format("there is no side {} in {} dimensions", side, scenario_.dimension));
      if (seen.contains(side.substr(0, 1)))
        refuse(key, fmt::format("the side {} cannot be a wall: the axis {} is periodic", side,
                                side.front()));
      if (!seen.insert(side).second) refuse(key, fmt::format("the side {} is a wall twice", side));
    }
  }

  void check_names() const {
    std::set<std::string> names;
    const auto check = [&](const std::string& name, const std::string& key) {
      if (!names.insert(name).second)
        refuse(key, fmt::format("there are two bodies with the name '{}'", name));
    };
    for (std::size_t k = 0; k < scenario_.domain.walls.size(); ++k)
      check(scenario_.domain.walls[k].name, fmt::format("domain.walls.{}", k));
    for (std::size_t k = 0; k < scenario_.regions.size(); ++k)
      check(scenario_.regions[k].name, fmt::format("regions.{}.name", k));
  }

  void check_velocity(const std::string& key, const WallSection& wall) const {
    if (wall.velocity.empty()) return;
    require_numbers(key, wall.velocity.size());
    for (std::size_t d = 0; d < wall.velocity.size(); ++d) {
      const Expression velocity(wall.velocity[d], scenario_.constants_by_name());
      for (const char* variable : {"x", "y", "z", "r"})
        if (velocity.uses(variable))
          refuse(fmt::format("{}.{}", key, d),
                 fmt::format("the velocity of a wall depends on t alone, and this names {}",
                             variable));
      if (!std::isfinite(velocity({})))
        refuse(fmt::format("{}.{}", key, d),
               "the velocity of the wall is not a finite number at t = 0");
    }
  }

  void require_numbers(const std::string& key, std::size_t count) const {
    if (count != static_cast<std::size_t>(scenario_.dimension))
      refuse(key, fmt::format("'{}' needs {} numbers, one a dimension, and has {}",
                              keys_of(key).back(), scenario_.dimension, count));
  }

  void check_region(std::size_t k) const {
    const RegionSection& region = scenario_.regions[k];
    const std::string key = fmt::format("regions.{}", k);
    if (region.is_wall()) check_velocity(key + ".velocity", region);
    for (std::size_t j = 0; j < region.shapes.size(); ++j)
      check_shape(fmt::format("{}.shapes.{}", key, j), region.shapes[j]);
    for (std::size_t j = 0; j < region.except.size(); ++j)
      check_shape(fmt::format("{}.except.{}", key, j), region.except[j]);
  }

  void check_shape(const std::string& key, const ShapeSection& shape) const {
    if (shape.type == "box") {
      require_numbers(key + ".lower", shape.lower.size());
      require_numbers(key + ".upper", shape.upper.size());
      for (std::size_t d = 0; d < shape.lower.size(); ++d)
        require_order(key + ".upper", shape.lower[d], shape.upper[d]);
    } else if (shape.type == "ball") {
      require_numbers(key + ".centre", shape.centre.size());
    } else if (shape.type == "polygon") {
      if (scenario_.dimension == 2 && (shape.z_lower || shape.z_upper))
        refuse(key + (shape.z_lower ? ".z_lower" : ".z_upper"),
               "a polygon has no ends along z in 2 dimensions");
      if (shape.z_lower && shape.z_upper)
        require_order(key + ".z_upper", *shape.z_lower, *shape.z_upper);
    } else {
      check_inside(key + ".inside", shape);
    }
  }

  void check_inside(const std::string& key, const ShapeSection& shape) const {
    const Expression inside(shape.inside, scenario_.constants_by_name());
    if (inside.uses("t")) refuse(key, "a shape does not depend on t");
    if (scenario_.dimension == 2 && inside.uses("z"))
      refuse(key, "there is no axis z in 2 dimensions");
  }

  void require_order(const std::string& key, double lower, double upper) const {
    if (!(upper > lower))
      refuse(key, fmt::format("the upper end {} must lie above the lower {}", upper, lower));
  }

  const Scenario& scenario_;
  const Document& document_;
};

}  // namespace

void check_line_or_space(const Scenario& scenario, const Document& document) {
  const Check check(scenario, document);
  if (scenario.model->lives_on_a_line())
    check.on_a_line();
  else
    check.in_space();
}

}  // namespace mote
