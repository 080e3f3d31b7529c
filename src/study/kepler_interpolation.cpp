#include "mote/study/kepler_interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mote/exact/kepler_orbit.hpp"
#include "mote/integrators/hermite.hpp"

namespace mote {

namespace {

constexpr int samples = 10;  // in a sub-interval

struct Scheme {
  int steps, derivatives;
};
constexpr std::array<Scheme, 4> schemes{{{1, 1}, {1, 2}, {2, 2}, {3, 2}}};

Row row(const std::array<double, 2>& vector) { return {vector[0], vector[1]}; }

double distance(const Row& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Nodes with this many derivatives at equal distances over the first period.
std::vector<KnownNode> nodes_on(const KeplerOrbit& orbit, int sub_intervals, int derivatives) {
  std::vector<KnownNode> nodes;
  for (int k = 0; k <= sub_intervals; ++k) {
    const double time = k * orbit.period() / sub_intervals;
    const auto [position, velocity, acceleration] = orbit.at(time);
    nodes.push_back({time, {row(position), row(velocity), row(acceleration)}});
    nodes.back().derivative.resize(derivatives + 1);
  }
  return nodes;
}

InterpolationError largest_error(const KeplerOrbit& orbit, int sub_intervals, Scheme scheme) {
  const std::vector<KnownNode> all = nodes_on(orbit, sub_intervals, scheme.derivatives);
  InterpolationError largest{};
  for (int k = 1; k <= sub_intervals; ++k) {
    const int first = std::max(k - scheme.steps, 0);
    const auto nodes = std::span(all).subspan(first, scheme.steps + 1);
    for (int sample = 1; sample < samples; ++sample) {
      const double time = std::lerp(all[k - 1].time, all[k].time, 1.0 * sample / samples);
      const OrbitState exact = orbit.at(time);
      const Interpolated found = interpolate(nodes, time);
      largest = {std::max(largest.position, distance(found.value, exact.position)),
                 std::max(largest.velocity, distance(found.rate, exact.velocity))};
    }
  }
  return largest;
}

}  // namespace

InterpolationErrors kepler_interpolation_errors(double eccentricity, int sub_intervals) {
  const KeplerOrbit orbit({.eccentricity = eccentricity});
  InterpolationErrors errors{};
  for (std::size_t s = 0; s < schemes.size(); ++s)
    errors[s] = largest_error(orbit, sub_intervals, schemes[s]);
  return errors;
}

}  // namespace mote
