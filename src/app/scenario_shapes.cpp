#include "mote/app/scenario_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mote/geometry/ball.hpp"
#include "mote/geometry/box.hpp"
#include "mote/geometry/formula_shape.hpp"
#include "mote/geometry/polygon.hpp"
#include "mote/particles/failure.hpp"
#include "mote/walls/outline.hpp"

namespace mote {
namespace {

SharedShape box_between(const std::vector<double>& lower, const std::vector<double>& upper) {
  Extent extent;
  std::ranges::copy(lower, extent.lower.begin());
  std::ranges::copy(upper, extent.upper.begin());
  return std::make_shared<Box>(extent);
}

SharedShape ball_of(const ShapeSection& section) {
  Triple centre{};
  std::ranges::copy(section.centre, centre.begin());
  return std::make_shared<Ball>(centre, section.radius);
}

SharedShape polygon_of(const ShapeSection& section, const std::string& key) {
  const std::string problem = polygon_problem(section.x, section.y);
  if (!problem.empty()) throw InputError(key, problem);
  return std::make_shared<Polygon>(section.x, section.y, section.z_lower.value_or(-Extent::endless),
                                   section.z_upper.value_or(Extent::endless));
}

SharedShape formula_of(const Scenario& scenario, const ShapeSection& section) {
  const auto inside = std::make_shared<Expression>(section.inside, scenario.constants_by_name());
  const auto function = [inside](const Triple& place) {
    return (*inside)({place[0], place[1], place[2]});
  };
  return std::make_shared<FormulaShape>(function, static_cast<int>(scenario.dimension),
                                        1e-4 * *scenario.particles.spacing);
}

SharedShape shape_of(const Scenario& scenario, const ShapeSection& section,
                     const std::string& key) {
  if (section.type == "box") return box_between(section.lower, section.upper);
  if (section.type == "ball") return ball_of(section);
  if (section.type == "polygon") return polygon_of(section, key);
  return formula_of(scenario, section);
}

std::vector<Triple> round_outline(const ShapeSection& ball, double side) {
  const double quarter = std::numbers::pi * ball.radius / 2;
  const auto sides = 4 * static_cast<Index>(std::ceil(quarter / side));
  std::vector<Triple> corners;
  for (const Complex corner :
       circle_outline({ball.centre[0], ball.centre[1]}, ball.radius, sides).corners)
    corners.push_back({corner.real(), corner.imag(), 0});
  return corners;
}

}  // namespace

std::vector<Triple> outline_of(const RegionSection& region, double side) {
  if (region.shapes.size() != 1 || !region.except.empty()) return {};
  const ShapeSection& shape = region.shapes.front();
  if (shape.type == "ball") return round_outline(shape, side);
  if (shape.type == "box")
    return {{shape.lower[0], shape.lower[1], 0},
            {shape.upper[0], shape.lower[1], 0},
            {shape.upper[0], shape.upper[1], 0},
            {shape.lower[0], shape.upper[1], 0}};
  std::vector<Triple> corners;
  for (std::size_t k = 0; k < shape.x.size(); ++k) corners.push_back({shape.x[k], shape.y[k], 0});
  return corners;
}

SharedShape union_of(const Scenario& scenario, const std::vector<ShapeSection>& sections,
                     const std::string& key) {
  std::vector<SharedShape> shapes;
  for (std::size_t k = 0; k < sections.size(); ++k)
    shapes.push_back(shape_of(scenario, sections[k], fmt::format("{}.{}", key, k)));
  if (shapes.size() == 1) return shapes.front();
  return std::make_shared<Union>(std::move(shapes));
}

SharedShape whole_domain(const Scenario& scenario) {
  return box_between(scenario.domain.lower, scenario.domain.upper);
}

}  // namespace mote
