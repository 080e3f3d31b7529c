#include "mote/integrators/hermite.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mote {

namespace {

using Numbers = std::vector<long double>;

/// Nodes in the order of Newton's polynomial, each as often as something is known there, at times
/// from the nearest one in units of `step`.
struct NewtonNodes {
  Numbers place;
  std::vector<int> node;
  long double step;
};

NewtonNodes newton_nodes(std::span<const double> times, int derivatives, int nearest) {
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  const long double origin = times[nearest];
  NewtonNodes nodes{{}, {}, times.size() > 1 ? (*last - origin) + (origin - *first) : 1.0L};
  const auto add = [&](int node) {
    nodes.place.insert(nodes.place.end(), derivatives + 1, (times[node] - origin) / nodes.step);
    nodes.node.insert(nodes.node.end(), derivatives + 1, node);
  };
  add(nearest);
  for (int node = 0; node < static_cast<int>(times.size()); ++node)
    if (node != nearest) add(node);
  return nodes;
}

/// Values and derivatives at `place` of Newton's polynomials 1, s - z_0, (s - z_0)(s - z_1), ...
std::array<Numbers, 2> newton_polynomials(const NewtonNodes& nodes, long double place) {
  Numbers values{1}, rates{0};
  for (std::size_t k = 0; k + 1 < nodes.place.size(); ++k) {
    const long double away = place - nodes.place[k];
    rates.push_back(rates[k] * away + values[k]);
    values.push_back(values[k] * away);
  }
  return {values, rates};
}

/// A number for each derivative at each node.
using PerKnown =
    std::array<std::array<long double, most_hermite_derivatives + 1>, most_hermite_nodes>;

/// What each known number counts for in the sum of `factors` times f[z_0], f[z_0, z_1], ...: the
/// table of divided differences read backwards. A difference
///   f[z_i, ..., z_i+l] = (f[z_i+1, ..., z_i+l] - f[z_i, ..., z_i+l-1])/(z_i+l - z_i)
/// hands on what it counts for to the two that it is made of; if all its nodes are one, it is
/// f^(l)/l! there.
PerKnown read_backwards(const NewtonNodes& nodes, const Numbers& factors) {
  constexpr std::array<long double, most_hermite_derivatives + 1> factorial{1, 1, 2};
  PerKnown counts{};
  Numbers share(1);
  for (std::size_t level = factors.size(); level-- > 0;) {
    share[0] += factors[level];
    Numbers next(share.size() + 1);
    for (std::size_t i = 0; i < share.size(); ++i) {
      if (nodes.node[i] == nodes.node[i + level]) {
        counts[nodes.node[i]][level] += share[i] / factorial[level];
        continue;
      }
      const long double part = share[i] / (nodes.place[i + level] - nodes.place[i]);
      next[i + 1] += part;
      next[i] -= part;
    }
    share = std::move(next);
  }
  return counts;
}

int nearest_of(std::span<const double> times, double time) {
  const auto nearer = [time](double a, double b) {
    return std::abs(a - time) < std::abs(b - time);
  };
  return static_cast<int>(std::min_element(times.begin(), times.end(), nearer) - times.begin());
}

}  // namespace

HermiteWeights::HermiteWeights(std::span<const double> times, int derivatives, double time)
    : nearest_(nearest_of(times, time)) {
  const NewtonNodes nodes = newton_nodes(times, derivatives, nearest_);
  const long double place = (static_cast<long double>(time) - times[nearest_]) / nodes.step;
  const auto [values, rates] = newton_polynomials(nodes, place);
  const PerKnown in_value = read_backwards(nodes, values), in_rate = read_backwards(nodes, rates);
  for (std::size_t node = 0; node < times.size(); ++node) {
    long double unit = 1;  // of the derivative, in steps
    for (int order = 0; order <= derivatives; ++order, unit *= nodes.step)
      weight_[node][order] = {static_cast<double>(in_value[node][order] * unit),
                              static_cast<double>(in_rate[node][order] * unit / nodes.step)};
  }
}

}  // namespace mote
