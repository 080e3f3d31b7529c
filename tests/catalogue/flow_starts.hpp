#pragma once

#include <map>
#include <string>

#include "mote/catalogue/exact_flows.hpp"

namespace mote::test {

/// A start in a plane and what a model would say of it, to be recognised as one of the flows.
struct PlaneStart {
  SpaceStart start;
  Parameters parameters{{"density", 2}, {"viscosity", 0.1}, {"gravity_x", 0}, {"gravity_y", 0}};

  /// A box from the origin without particles.
  PlaneStart(double width, double height, double spacing) {
    start.upper = {width, height, 0};
    start.spacing = spacing;
    start.bodies = {{"water", BodyKind::fluid}};
    start.initial = [](std::string_view, const Triple&) { return 0.0; };
  }

  /// Fluid wherever `inside` holds, at the middles of cells.
  template <class Inside>
  PlaneStart& fill(Inside inside) {
    for (double y = start.lower[1] + 0.5 * start.spacing; y < start.upper[1]; y += start.spacing)
      for (double x = start.lower[0] + 0.5 * start.spacing; x < start.upper[0]; x += start.spacing)
        if (inside(x, y)) add(x, y, 0);
    return *this;
  }

  /// A plane wall along x, one particle deep, with the fluid above it (+1) or below it (-1).
  PlaneStart& wall(const std::string& name, double surface, double side) {
    start.bodies.push_back({name, BodyKind::wall});
    const auto number = static_cast<std::int32_t>(start.bodies.size() - 1);
    for (double x = start.lower[0] + 0.5 * start.spacing; x < start.upper[0]; x += start.spacing) {
      add(x, surface - side * 0.5 * start.spacing, number);
      start.wall_places.push_back({0.5 * start.spacing, {0, side, 0}});
    }
    return *this;
  }

  FlowSetup setup() const { return {start, parameters, initial}; }

 private:
  Cloud initial{2, 0};  ///< for solutions that follow single points, which none of these does

  void add(double x, double y, std::int32_t body) {
    start.position.insert(start.position.end(), {x, y});
    start.body.push_back(body);
  }
};

/// Initial velocities (u, v) as functions of the place; other fields are 0.
template <class U, class V>
auto velocities(U u, V v) {
  return [u, v](std::string_view field, const Triple& place) {
    if (field == "velocity_x") return static_cast<double>(u(place[0], place[1]));
    if (field == "velocity_y") return static_cast<double>(v(place[0], place[1]));
    return 0.0;
  };
}

/// The message with which a flow is refused; empty if it is not.
template <class Make>
std::string refusal(Make make, const PlaneStart& plane) {
  try {
    make(plane.setup());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace mote::test
