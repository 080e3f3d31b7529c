#include "mote/walls/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mote/geometry/polygon.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

double cross(Complex a, Complex b) { return (std::conj(a) * b).imag(); }

void check(const Outline& outline) {
  std::vector<double> x, y;
  for (const Complex corner : outline.corners) {
    x.push_back(corner.real());
    y.push_back(corner.imag());
  }
  if (const std::string problem = polygon_problem(x, y); !problem.empty())
    throw InputError(problem);
}

}  // namespace

Outline circle_outline(Complex centre, double radius, Index sides) {
  const double angle = 2 * std::numbers::pi / sides;
  const double reach = radius * std::sqrt(angle / std::sin(angle));
  Outline outline;
  for (Index k = 0; k < sides; ++k)
    outline.corners.push_back(centre + std::polar(reach, k * angle));
  return outline;
}

double area_of(const Outline& outline) {
  const auto& corners = outline.corners;
  const Complex first = corners.front();
  double twice = 0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    twice += cross(corners[k] - first, corners[k + 1] - first);
  return twice / 2;
}

std::vector<Panel> panels_of(const Outline& outline, double length) {
  check(outline);
  std::vector<Complex> corners = outline.corners;
  if (area_of(outline) < 0) std::ranges::reverse(corners);
  std::vector<Panel> panels;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Complex from = corners[k], side = corners[(k + 1) % corners.size()] - from;
    const int count = static_cast<int>(std::ceil(std::abs(side) / length * (1 - 1e-12)));
    const auto end = [&](int n) { return from + side * (static_cast<double>(n) / count); };
    for (int n = 0; n < count; ++n) panels.push_back({end(n), end(n + 1)});
  }
  for (std::size_t k = 0; k < panels.size(); ++k)  // ends that are the same to the last bit
    panels[k].to = panels[(k + 1) % panels.size()].from;
  return panels;
}

}  // namespace mote
