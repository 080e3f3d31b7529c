#include "mote/study/kepler_interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mote/exact/kepler_orbit.hpp"
#include "mote/integrators/hermite.hpp"

namespace mote {

namespace {

constexpr int samples = 10;  // in a sub-interval

/// The nodes of a polynomial, and what is known there.
struct Nodes {
  std::vector<double> time;
  std::vector<OrbitState> state;
};

struct Scheme {
  int steps, derivatives;
};
constexpr std::array<Scheme, 4> schemes{{{1, 1}, {1, 2}, {2, 2}, {3, 2}}};

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Position and velocity of the polynomial through these nodes.
OrbitState interpolated(const Nodes& nodes, int derivatives, double time) {
  const HermiteWeights weights(nodes.time, derivatives, time);
  const auto& origin = nodes.state[weights.nearest()].position;
  OrbitState result{origin, {}, {}};
  for (std::size_t node = 0; node < nodes.time.size(); ++node) {
    const auto& [position, velocity, acceleration] = nodes.state[node];
    for (std::size_t d = 0; d < 2; ++d) {
      const std::array<double, 3> known{position[d] - origin[d], velocity[d], acceleration[d]};
      for (int order = 0; order <= derivatives; ++order) {
        const HermiteWeight& weight = weights.weight(static_cast<int>(node), order);
        result.position[d] += weight.value * known[order];
        result.velocity[d] += weight.rate * known[order];
      }
    }
  }
  return result;
}

Nodes some(const Nodes& all, int first, int count) {
  return {{all.time.begin() + first, all.time.begin() + first + count},
          {all.state.begin() + first, all.state.begin() + first + count}};
}

InterpolationError largest_error(const KeplerOrbit& orbit, const Nodes& all, Scheme scheme) {
  InterpolationError largest{};
  for (std::size_t k = 1; k < all.time.size(); ++k) {
    const int first = std::max(static_cast<int>(k) - scheme.steps, 0);
    const Nodes nodes = some(all, first, scheme.steps + 1);
    for (int sample = 1; sample < samples; ++sample) {
      const double time = std::lerp(all.time[k - 1], all.time[k], 1.0 * sample / samples);
      const OrbitState exact = orbit.at(time);
      const OrbitState found = interpolated(nodes, scheme.derivatives, time);
      largest = {std::max(largest.position, distance(found.position, exact.position)),
                 std::max(largest.velocity, distance(found.velocity, exact.velocity))};
    }
  }
  return largest;
}

}  // namespace

InterpolationErrors kepler_interpolation_errors(double eccentricity, int sub_intervals) {
  const KeplerOrbit orbit({.eccentricity = eccentricity});
  Nodes nodes;
  for (int k = 0; k <= sub_intervals; ++k) {
    nodes.time.push_back(k * orbit.period() / sub_intervals);
    nodes.state.push_back(orbit.at(nodes.time.back()));
  }
  InterpolationErrors errors{};
  for (std::size_t s = 0; s < schemes.size(); ++s)
    errors[s] = largest_error(orbit, nodes, schemes[s]);
  return errors;
}

}  // namespace mote
