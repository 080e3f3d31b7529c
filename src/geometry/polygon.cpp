#include "mote/geometry/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mote {
namespace {

struct Point {
  double x, y;
};

Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

double distance_from_edge(const Point& place, const Point& from, const Point& to) {
  const Point edge = to - from, offset = place - from;
  const double along = std::clamp(dot(offset, edge) / dot(edge, edge), 0.0, 1.0);
  return std::hypot(offset.x - along * edge.x, offset.y - along * edge.y);
}

/// On which side of the line from a to b the point c lies: 1, -1, or 0 on it.
int side_of(const Point& a, const Point& b, const Point& c) {
  const double area = cross(b - a, c - a);
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

/// Whether c, a point of the line through a and b, lies between them.
bool is_between(const Point& a, const Point& b, const Point& c) { return dot(a - c, b - c) <= 0; }

bool touch(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int c_side = side_of(a, b, c), d_side = side_of(a, b, d);
  const int a_side = side_of(c, d, a), b_side = side_of(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && is_between(a, b, c)) || (d_side == 0 && is_between(a, b, d)) ||
         (a_side == 0 && is_between(c, d, a)) || (b_side == 0 && is_between(c, d, b));
}

/// Whether an edge goes back on the one before it.
bool turns_back(const Point& before, const Point& corner, const Point& next) {
  return side_of(before, corner, next) == 0 && dot(before - corner, next - corner) > 0;
}

}  // namespace

std::string polygon_problem(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t count = x.size();
  if (count != y.size())
    return fmt::format("a polygon needs as many 'x' as 'y', and has {} and {}", count, y.size());
  if (count < 3) return fmt::format("a polygon needs at least 3 corners, and has {}", count);
  const auto corner = [&](std::size_t k) { return Point{x[k % count], y[k % count]}; };
  const auto in_words = [&](std::size_t k) {
    return fmt::format("the edge from ({:.6g}, {:.6g})", corner(k).x, corner(k).y);
  };
  for (std::size_t i = 0; i < count; ++i)
    if (corner(i).x == corner(i + 1).x && corner(i).y == corner(i + 1).y)
      return fmt::format("the polygon has a corner twice running: ({:.6g}, {:.6g})", corner(i).x,
                         corner(i).y);
  for (std::size_t i = 0; i < count; ++i) {
    if (turns_back(corner(i), corner(i + 1), corner(i + 2)))
      return fmt::format("the polygon turns back on itself at ({:.6g}, {:.6g})", corner(i + 1).x,
                         corner(i + 1).y);
    for (std::size_t j = i + 2; j < count && (i > 0 || j + 1 < count); ++j)
      if (touch(corner(i), corner(i + 1), corner(j), corner(j + 1)))
        return fmt::format("the polygon crosses itself: {} meets {}", in_words(i), in_words(j));
  }
  return "";
}

double Polygon::distance_in_the_plane(double x, double y) const {
  const Point place{x, y};
  double nearest = Extent::endless;
  bool inside = false;
  for (std::size_t k = 0, before = x_.size() - 1; k < x_.size(); before = k++) {
    const Point from{x_[before], y_[before]}, to{x_[k], y_[k]};
    nearest = std::min(nearest, distance_from_edge(place, from, to));
    const bool passes = (from.y > y) != (to.y > y);
    if (passes && x < from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y)) inside = !inside;
  }
  return inside ? -nearest : nearest;
}

double Polygon::distance(const Triple& place) const {
  const double across = distance_in_the_plane(place[0], place[1]);
  const double along = std::max(bottom_ - place[2], place[2] - top_);
  if (across > 0 && along > 0) return std::hypot(across, along);
  return std::max(across, along);
}

Extent Polygon::extent() const {
  return {{std::ranges::min(x_), std::ranges::min(y_), bottom_},
          {std::ranges::max(x_), std::ranges::max(y_), top_}};
}

}  // namespace mote
