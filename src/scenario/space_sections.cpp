#include "mote/scenario/space_sections.hpp"

namespace mote {
namespace {

constexpr Word<bool> slips[] = {{false, "none", "the fluid sticks to it"},
                                {true, "free", "the fluid slips along it"}};

const Choices sides{{"x_lower", "where x is lowest"}, {"x_upper", "where x is highest"},
                    {"y_lower", "where y is lowest"}, {"y_upper", "where y is highest"},
                    {"z_lower", "where z is lowest"}, {"z_upper", "where z is highest"}};

void describe_wall(Description& d, WallSection& wall) {
  describe_words(d, {"slip", "whether the fluid sticks to it"}, wall.slips, slips);
  d.expressions(
      {"velocity", "of the wall, one expression in t a dimension; default: it stands still"},
      wall.velocity);
  d.flag({"travels", "whether its particles go along with the velocity, or it only drags"},
         wall.travels);
}

void describe_shape(Description& d, ShapeSection& shape) {
  const Choices types{{"box", "between two corners"},
                      {"ball", "round a centre; in the plane a disc"},
                      {"polygon", "in the plane; in space a prism along z over it"},
                      {"expression", "where an expression is positive"}};
  d.variant({"type", "form of the shape", true}, shape.type, types, [&](const std::string& type) {
    if (type == "box") {
      d.numbers({"lower", "lower corner, one number a dimension", true}, shape.lower);
      d.numbers({"upper", "upper corner, one number a dimension", true}, shape.upper);
    } else if (type == "ball") {
      d.numbers({"centre", "one number a dimension", true}, shape.centre);
      d.number({"radius", "of the ball", true}, shape.radius, positive);
    } else if (type == "polygon") {
      d.numbers({"x", "of the corners, in order", true}, shape.x);
      d.numbers({"y", "of the corners, in order", true}, shape.y);
      d.number({"z_lower", "where the prism begins; default: nowhere"}, shape.z_lower);
      d.number({"z_upper", "where the prism ends; default: nowhere"}, shape.z_upper);
    } else if (type == "expression") {
      d.expression({"inside", "positive inside, negative outside", true}, shape.inside);
    }
  });
}

void describe_region(Description& d, RegionSection& region) {
  d.text({"name", "of the fluid or the wall", true}, region.name);
  d.variant({"type", "what fills the region", true}, region.type,
            {{"fluid", "the model's fluid"}, {"wall", "a wall"}}, [&](const std::string& type) {
              if (type == "wall") describe_wall(d, region);
            });
  const auto describe_one = [&](ShapeSection& shape) { describe_shape(d, shape); };
  describe_list(d, {"shapes", "the region is all of these together", true}, region.shapes,
                describe_one);
  describe_list(d, {"except", "less these; a wall then faces the hollow that they leave"},
                region.except, describe_one);
}

}  // namespace

void describe_side_walls(Description& d, std::vector<SideWallSection>& walls) {
  describe_list(d, {"walls", "sides that are walls; the rest, unless periodic, is open"}, walls,
                [&](SideWallSection& wall) {
                  d.choice({"side", "which side of the domain", true}, wall.side, sides);
                  if (wall.name.empty()) wall.name = wall.side;
                  d.text({"name", "of the wall; default: the side"}, wall.name);
                  describe_wall(d, wall);
                });
}

void describe_regions(Description& d, std::vector<RegionSection>& regions) {
  describe_list(d,
                {"regions",
                 "fluids and walls; without a fluid, one fills the domain around the walls, and "
                 "beyond periodic sides there is no wall"},
                regions, [&](RegionSection& region) {
                  if (region.type.empty()) region.travels = true;
                  describe_region(d, region);
                });
}

void describe_neighbours(Description& d, NeighboursSection& neighbours) {
  d.choice({"search", "how neighbours are found"}, neighbours.search,
           {{"automatic", "the model chooses"},
            {"line", "along a line"},
            {"cell_grid", "by a grid of cells, in space"},
            {"kd_tree", "by a k-d tree, in space"}});
  d.number({"skin",
            "how much further than the operator the lists reach, relative; default: the "
            "model chooses"},
           neighbours.skin, not_negative);
}

SideName side_named(const std::string& name) {
  return {name.front() - 'x', name.ends_with("upper")};
}

}  // namespace mote
