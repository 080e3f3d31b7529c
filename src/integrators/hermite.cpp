#include "mote/integrators/hermite.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mote/particles/parallel.hpp"

namespace mote {

namespace {

using Numbers = std::vector<long double>;

/// Nodes in the order of Newton's polynomials, each as often as something is known there, at times
/// from the nearest one in units of the time that all of them span.
struct NewtonNodes {
  Numbers place;
  std::vector<std::size_t> node;
  long double span;
};

NewtonNodes newton_nodes(std::span<const HermiteNode> nodes, std::size_t nearest) {
  const auto [first, last] = std::ranges::minmax(nodes, {}, &HermiteNode::time);
  const long double origin = nodes[nearest].time;
  NewtonNodes result{{}, {}, (last.time - origin) + (origin - first.time)};
  if (nodes.size() == 1) result.span = 1;
  const auto add = [&](std::size_t node) {
    const int known = nodes[node].derivatives + 1;
    result.place.insert(result.place.end(), known, (nodes[node].time - origin) / result.span);
    result.node.insert(result.node.end(), known, node);
  };
  add(nearest);
  for (std::size_t node = 0; node < nodes.size(); ++node)
    if (node != nearest) add(node);
  return result;
}

/// Values and derivatives at `place` of Newton's polynomials 1, s - z_0, (s - z_0)(s - z_1), ...
struct NewtonPolynomials {
  Numbers value{1}, rate{0};
};

NewtonPolynomials newton_polynomials(const NewtonNodes& nodes, long double place) {
  NewtonPolynomials polynomials;
  auto& [value, rate] = polynomials;
  for (std::size_t k = 0; k + 1 < nodes.place.size(); ++k) {
    const long double away = place - nodes.place[k];
    rate.push_back(rate[k] * away + value[k]);
    value.push_back(value[k] * away);
  }
  return polynomials;
}

/// What each known number counts for in the sum of `factors` times f[z_0], f[z_0, z_1], ..., by
/// node and order: the table of divided differences read backwards. A difference
///   f[z_i, ..., z_i+l] = (f[z_i+1, ..., z_i+l] - f[z_i, ..., z_i+l-1])/(z_i+l - z_i)
/// hands on what it counts for to the two that it is made of; if all its nodes are one, it is
/// f^(l)/l! there.
std::vector<Numbers> read_backwards(const NewtonNodes& nodes, const Numbers& factors,
                                    std::size_t node_count) {
  std::vector<Numbers> counts(node_count, Numbers(factors.size()));
  Numbers share(1);
  long double factorial = std::tgamma(static_cast<long double>(factors.size() + 1));
  for (std::size_t level = factors.size(); level-- > 0;) {
    factorial /= static_cast<long double>(level + 1);
    share[0] += factors[level];
    Numbers next(share.size() + 1);
    for (std::size_t i = 0; i < share.size(); ++i) {
      if (nodes.node[i] == nodes.node[i + level]) {
        counts[nodes.node[i]][level] += share[i] / factorial;
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

std::size_t nearest_of(std::span<const HermiteNode> nodes, double time) {
  const auto away = [time](const HermiteNode& node) { return std::abs(node.time - time); };
  return std::ranges::min_element(nodes, {}, away) - nodes.begin();
}

}  // namespace

HermiteWeights::HermiteWeights(std::span<const HermiteNode> nodes, double time)
    : weight_(nodes.size()), nearest_(nearest_of(nodes, time)) {
  const NewtonNodes newton = newton_nodes(nodes, nearest_);
  const long double place = (time - static_cast<long double>(nodes[nearest_].time)) / newton.span;
  const NewtonPolynomials polynomials = newton_polynomials(newton, place);
  const auto in_value = read_backwards(newton, polynomials.value, nodes.size());
  const auto in_rate = read_backwards(newton, polynomials.rate, nodes.size());
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    long double unit = 1;  // of the derivative
    for (int order = 0; order <= nodes[node].derivatives; ++order, unit *= newton.span)
      weight_[node].push_back({static_cast<double>(in_value[node][order] * unit),
                               static_cast<double>(in_rate[node][order] * unit / newton.span)});
  }
}

Interpolated interpolate(std::span<const KnownNode> nodes, double time) {
  std::vector<HermiteNode> places;
  for (const auto& [at, derivative] : nodes)
    places.push_back({at, static_cast<int>(derivative.size()) - 1});
  const HermiteWeights weights(places, time);
  const Row& origin = nodes[weights.nearest()].derivative[0];
  const auto size = static_cast<std::ptrdiff_t>(origin.size());
  Interpolated result{Row(origin.size()), Row(origin.size())};
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (std::ptrdiff_t i = 0; i < size; ++i) {
    double change = 0, rate = 0;
    for (std::size_t node = 0; node < nodes.size(); ++node)
      for (std::size_t order = 0; order < nodes[node].derivative.size(); ++order) {
        const HermiteWeight& weight = weights.at(node)[order];
        const double known = nodes[node].derivative[order][i] - (order == 0 ? origin[i] : 0);
        change += weight.value * known;
        rate += weight.rate * known;
      }
    result.value[i] = origin[i] + change;
    result.rate[i] = rate;
  }
  return result;
}

}  // namespace mote
