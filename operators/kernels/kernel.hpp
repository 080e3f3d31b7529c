#pragma once

#include <concepts>
#include <string_view>

#include "mote/neighbours/neighbours.hpp"
#include "mote/operators/differential/lanes.hpp"
#include "mote/options/description.hpp"

namespace mote {

/// A smoothing kernel in D dimensions as a function of q = r/h:
///   W(r) = value(q)/h^D,  W'(r) = q slope_over_q(q)/h^(D+1),  W''(r) = curvature(q)/h^(D+2).
/// It vanishes beyond q = support(), its integral over space is 1, and slope_over_q is finite at
/// q = 0, so coincident points need no special case. `usual_length` is the smoothing length in
/// spacings that a scenario gets when it names none.
///
/// Receiver i, neighbour j, x_ij = x_i - x_j; the gradient of W is taken at i.
template <class K>
concept SmoothingKernel = requires(const K kernel, double q) {
  { K::name } -> std::convertible_to<std::string_view>;
  { K::summary } -> std::convertible_to<std::string_view>;
  { K::usual_length } -> std::convertible_to<double>;
  { kernel.support() } -> std::convertible_to<double>;
  { kernel.value(q) } -> std::convertible_to<double>;
  { kernel.slope_over_q(q) } -> std::convertible_to<double>;
  { kernel.curvature(q) } -> std::convertible_to<double>;
};

/// A kernel may have options of its own; it then says so with `describe`.
template <class K>
concept HasOptions = requires(K kernel, Description& description) {
  kernel.describe(description);
};

/// Whether q lies in the support. The rim counts as inside: a neighbour exactly there keeps its
/// curvature although its distance is rounded (ERRATA on (90)).
constexpr bool inside(double q, double support) { return q <= support * rim_tolerance; }

/// A kernel's formula within the support, and 0 beyond it, for one number or for lanes of them.
constexpr double cut(double formula, double q, double support) {
  return inside(q, support) ? formula : 0;
}
[[gnu::always_inline]] inline Lanes cut(Lanes formula, const Lanes& q, double support) {
  where(q > support * rim_tolerance, formula) = 0;
  return formula;
}

/// A kernel with formulas for lanes.
template <class K>
concept LaneKernel = requires(const K kernel, const Lanes q) {
  { kernel.value(q) } -> std::convertible_to<Lanes>;
  { kernel.slope_over_q(q) } -> std::convertible_to<Lanes>;
};

/// Eight values of a kernel's function at a time. A kernel that has no formulas for lanes is asked
/// lane by lane.
template <class K>
[[gnu::always_inline]] inline Lanes value_of(const K& kernel, const Lanes& q) {
  if constexpr (LaneKernel<K>)
    return kernel.value(q);
  else
    return Lanes([&](auto lane) { return kernel.value(q[lane]); });
}
template <class K>
[[gnu::always_inline]] inline Lanes slope_over_q_of(const K& kernel, const Lanes& q) {
  if constexpr (LaneKernel<K>)
    return kernel.slope_over_q(q);
  else
    return Lanes([&](auto lane) { return kernel.slope_over_q(q[lane]); });
}

}  // namespace mote
