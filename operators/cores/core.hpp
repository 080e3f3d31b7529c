#pragma once

#include <concepts>
#include <string_view>

#include "mote/operators/differential/lanes.hpp"

namespace mote {

/// The functions of a core in D dimensions; Real is double or Lanes.
template <class C, int D, class Real>
concept CoreFunctions = requires(const Real& rho_squared) {
  { C::template influence<D>(rho_squared) } -> std::convertible_to<Real>;
  { C::template influence_slope<D>(rho_squared) } -> std::convertible_to<Real>;
  { C::template blob<D>(rho_squared) } -> std::convertible_to<Real>;
  { C::template potential<D>(rho_squared) } -> std::convertible_to<Real>;
  { C::template reach<D>(0.1) } -> std::convertible_to<double>;
};

/// A vortex core: how circulation, or mass, is spread about the place of a particle, in 2 and 3
/// dimensions. With rho = r/core_size and q(rho) the part of it that lies within rho, q(0) = 0 and
/// q -> 1, S_2 = 2 pi and S_3 = 4 pi, all as functions of rho^2 and finite at 0:
///   influence        q/rho^D, which stands where points have 1/rho^D,
///   influence_slope  (1/rho) d(q/rho^D)/drho,
///   blob             zeta = q'/(S_D rho^(D-1)), the density, whose integral over space is 1,
///   potential        2D: -> ln rho far away, with the slope q/rho,
///                    3D: -> 1/rho far away, with the slope -q/rho^2.
/// A core has order m if its moments 2, 4, ..., m - 2 vanish: it changes a smooth field by
/// O(core_size^m). Beyond rho = reach(tolerance) it is a point to within `tolerance` > 0 of the
/// field and of the field's gradient: |1 - q| + rho |q'| < tolerance.
template <class C>
concept VortexCore = CoreFunctions<C, 2, double> && CoreFunctions<C, 2, Lanes> &&
    CoreFunctions<C, 3, double> && CoreFunctions<C, 3, Lanes> && requires {
  { C::name } -> std::convertible_to<std::string_view>;
  { C::summary } -> std::convertible_to<std::string_view>;
  { C::order } -> std::convertible_to<int>;
};

/// Where a function that falls to 0 beyond `start` gets below `bound` > 0.
template <class Function>
double end_of_fall(Function f, double start, double bound) {
  double lower = start, upper = start + 1;
  while (!(f(upper) < bound)) upper *= 2;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (lower + upper) / 2;
    (f(middle) < bound ? upper : lower) = middle;
  }
  return upper;
}

}  // namespace mote
