#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mote/operators/terms/fluid_terms.hpp"
#include "support/random.hpp"

namespace mote::test {

/// A sum, and the sum of its terms' magnitudes, which rounding is measured against.
struct PlainSum {
  double value = 0, magnitude = 0;

  PlainSum& operator+=(double term) {
    value += term;
    magnitude += std::abs(term);
    return *this;
  }
};

/// Particles of a fluid in disorder, all of the mass `mass`, in a box about as wide as a kernel.
template <int D>
struct FluidInABox {
  double mass = 0.6, smoothing_length = 0.7;
  std::vector<PairLine<D>> lines;

  Index count() const { return static_cast<Index>(lines.size()); }
};

template <int D>
FluidInABox<D> fluid_in_a_box(double support, Index count = 60) {
  using Line = PairLine<D>;
  FluidInABox<D> fluid;
  const double width = 1.4 * support * fluid.smoothing_length;
  Draws draws(7);
  fluid.lines.resize(static_cast<std::size_t>(count));
  for (Line& line : fluid.lines) {
    for (std::size_t d = 0; d < D; ++d) {
      line.value[Line::position + d] = draws.uniform(0, width);
      line.value[Line::velocity + d] = draws.uniform(-1, 1);
    }
    line.value[Line::volume] = draws.uniform(0.4, 0.8);
    line.value[Line::pressure] = draws.uniform(-2, 5);
  }
  return fluid;
}

using PlainLists = std::vector<std::vector<Index>>;

/// Everybody is everybody's neighbour.
inline PlainLists all_of_all(Index count) {
  PlainLists lists(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j)
      if (j != i) lists[static_cast<std::size_t>(i)].push_back(j);
  return lists;
}

/// Those within `reach` smoothing lengths.
template <int D>
PlainLists within(const FluidInABox<D>& fluid, double reach) {
  PlainLists lists = all_of_all(fluid.count());
  for (std::size_t i = 0; i < lists.size(); ++i)
    std::erase_if(lists[i], [&](Index j) {
      const Vec<D> x = fluid.lines[i].place() - fluid.lines[static_cast<std::size_t>(j)].place();
      return x.norm() > reach * fluid.smoothing_length;
    });
  return lists;
}

/// One pair in plain numbers, F = W'(r)/r and W by the kernel's scalar functions.
template <int D>
struct PlainPair {
  Vec<D> x, u;
  double r, q, f, w, volume, density_i, density_j, pressure_i, pressure_j;

  template <class Kernel>
  PlainPair(const FluidInABox<D>& fluid, const Kernel& kernel, std::size_t i, std::size_t j) {
    using Line = PairLine<D>;
    const Line &a = fluid.lines[i], &b = fluid.lines[j];
    x = a.place() - b.place();
    u = a.speed() - b.speed();
    double squared = x[0] * x[0];
    for (int d = 1; d < D; ++d) squared += x[d] * x[d];
    r = std::sqrt(squared);
    q = r * (1 / fluid.smoothing_length);
    f = kernel.slope_over_q(q) / std::pow(fluid.smoothing_length, D + 2);
    w = kernel.value(q) / std::pow(fluid.smoothing_length, D);
    volume = b.value[Line::volume];
    density_i = fluid.mass / a.value[Line::volume];
    density_j = fluid.mass / volume;
    pressure_i = a.value[Line::pressure];
    pressure_j = b.value[Line::pressure];
  }
};

/// What FluidTerms::add_up is to give for one receiver, by its formula, term by term.
template <int D>
struct PlainRates {
  PlainSum acceleration[D], density_rate, dissipation;
  std::int64_t pairs = 0;
};

template <int D, class Kernel>
PlainRates<D> plain_rates(const FluidInABox<D>& fluid, const Kernel& kernel, std::size_t i,
                          const std::vector<Index>& neighbours, const FluidCoefficients<D>& c) {
  PlainRates<D> rates;
  const double h = fluid.smoothing_length;
  const double volume_i = fluid.lines[i].value[PairLine<D>::volume];
  for (const Index j : neighbours) {
    const PlainPair<D> pair(fluid, kernel, i, static_cast<std::size_t>(j));
    const double vf = pair.volume * pair.f, approach = pair.u.dot(pair.x);
    if (pair.q <= kernel.support()) ++rates.pairs;
    for (int d = 0; d < D && c.continuity; ++d)
      rates.density_rate += pair.density_i * vf * pair.u[d] * pair.x[d];
    rates.density_rate += -2 * c.diffusion * vf * pair.density_j;
    rates.density_rate += 2 * c.diffusion * vf * pair.density_i;
    for (int d = 0; d < D; ++d)
      rates.density_rate += -2 * c.diffusion * vf * pair.x[d] * c.density_at_rest[d];
    const double brake =
        c.artificial_viscosity * std::min(approach, 0.0) / (pair.r * pair.r + 0.01 * h * h);
    for (int d = 0; d < D; ++d) {
      const double share = vf / pair.density_i;
      if (c.pressure) {
        rates.acceleration[d] += -share * pair.pressure_i * pair.x[d];
        rates.acceleration[d] += -share * pair.pressure_j * pair.x[d];
      }
      rates.acceleration[d] += share * brake * pair.x[d];
      rates.acceleration[d] += share * 2 * c.viscosity * pair.u[d];
      // Half the power of the pair's friction: the other half is met from the other end.
      rates.dissipation +=
          -0.5 * volume_i * vf * (brake * pair.x[d] + 2 * c.viscosity * pair.u[d]) * pair.u[d];
    }
  }
  return rates;
}

}  // namespace mote::test
