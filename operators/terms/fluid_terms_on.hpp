#pragma once

#include <algorithm>
#include <cmath>

#include "mote/operators/kernels/kernel.hpp"
#include "mote/operators/terms/fluid_terms.hpp"

namespace mote {

/// The difference of a receiver to eight neighbours, and their distance in smoothing lengths.
template <int D>
struct EightPairs {
  Lanes x[D], squared, q;

  [[gnu::always_inline]] EightPairs(const PairLine<D>& receiver, const LineLanes& lanes,
                                    double inverse_length) {
    for (int d = 0; d < D; ++d)
      x[d] = receiver.value[PairLine<D>::position + d] - lanes[PairLine<D>::position + d];
    squared = x[0] * x[0];
    for (int d = 1; d < D; ++d) squared = squared + x[d] * x[d];
    q = sqrt(squared) * inverse_length;
  }
};

/// The pair terms on one kernel; see FluidTerms.
template <int D, class Kernel>
class FluidTermsOn final : public FluidTerms<D> {
 public:
  using Line = PairLine<D>;
  using Lines = std::span<const PairLine<D>>;

  explicit FluidTermsOn(const Kernel& kernel = {}) : kernel_(kernel) {}

  double support() const override { return kernel_.support(); }

  FluidPass add_up(Lines lines, const NeighbourLists& lists, std::span<const std::uint8_t> idle,
                   double smoothing_length, const FluidCoefficients<D>& coefficients,
                   const FluidRates<D>& rates) const override {
    const Index receivers = lists.receivers();
    const Index blocks = (receivers + block_size - 1) / block_size;
    passes_.assign(static_cast<std::size_t>(blocks), {});
#pragma omp parallel for schedule(dynamic, 4) if (parallel_from <= receivers)
    for (Index block = 0; block < blocks; ++block) {
      const Index end = std::min(receivers, (block + 1) * block_size);
      for (Index i = block * block_size; i < end; ++i)
        if (!idle[i])
          add_up_one(lines, i, lists[i], smoothing_length, coefficients, rates,
                     passes_[static_cast<std::size_t>(block)]);
    }
    FluidPass all;
    for (const FluidPass& pass : passes_) {
      all.pairs += pass.pairs;
      all.dissipation += pass.dissipation;
    }
    return all;
  }

  [[gnu::flatten]] double density(Lines lines, Index i, std::span<const Index> neighbours,
                                  double smoothing_length, double mass) const override {
    const double inverse = 1 / smoothing_length;
    const Line& receiver = lines[static_cast<std::size_t>(i)];
    Lanes sum = 0;
    std::size_t missing = 0;
    for_each_eight<D>(lines, i, neighbours, [&](const LineLanes& lanes, std::size_t valid) {
      sum += value_of(kernel_, EightPairs<D>(receiver, lanes, inverse).q);
      missing = lane_count - valid;
    });
    const double own = kernel_.value(0.0) * (1 - static_cast<double>(missing));
    return mass * (sum_of(sum) + own) * over_length(inverse, D);
  }

  [[gnu::flatten]] FluidSeen<D> seen(Lines lines, Index i, std::span<const Index> neighbours,
                                     double smoothing_length, double mass,
                                     const Surface<D>& surface) const override {
    const double inverse = 1 / smoothing_length;
    const Line& receiver = lines[static_cast<std::size_t>(i)];
    Lanes weight = 0, pressure = 0, offset[D], velocity[D], slope[D], width = 0;
    for (int d = 0; d < D; ++d) offset[d] = velocity[d] = slope[d] = 0;
    for_each_eight<D>(lines, i, neighbours, [&](const LineLanes& lanes, std::size_t valid) {
      const EightPairs<D> pair(receiver, lanes, inverse);
      Lanes w = value_of(kernel_, pair.q);
      for (std::size_t lane = valid; lane < lane_count; ++lane) w[lane] = 0;
      const Lanes vw = w * lanes[Line::volume];
      weight += vw;
      pressure += vw * lanes[Line::pressure];
      Lanes height = -surface.depth;
      for (int d = 0; d < D; ++d) height -= surface.normal[d] * pair.x[d];
      where(height < surface.nearest, height) = surface.nearest;
      width += vw * height * height;
      for (int d = 0; d < D; ++d) {
        offset[d] += w * pair.x[d];
        velocity[d] += vw * lanes[Line::velocity + d];
        slope[d] += vw * height * (lanes[Line::velocity + d] - surface.velocity[d]);
      }
    });
    FluidSeen<D> seen{.weight = sum_of(weight)};
    if (seen.weight <= 0) return seen;
    const double spread = sum_of(width);
    seen.pressure = sum_of(pressure) / seen.weight;
    for (int d = 0; d < D; ++d) {
      seen.offset[d] = mass * sum_of(offset[d]) / seen.weight;
      seen.velocity[d] = sum_of(velocity[d]) / seen.weight;
      seen.shear[d] = spread > 0 ? sum_of(slope[d]) / spread : 0;
    }
    return seen;
  }

  double linear_diffusion(Lines lines, Index i, std::span<const Index> neighbours,
                          double smoothing_length, std::span<const Vec<D>> slopes) const override {
    const double inverse = 1 / smoothing_length;
    const Line& receiver = lines[static_cast<std::size_t>(i)];
    double sum = 0;
    for (const Index j : neighbours) {
      const Line& other = lines[static_cast<std::size_t>(j)];
      const Vec<D> x = receiver.place() - other.place();
      const Vec<D> slope =
          slopes[static_cast<std::size_t>(i)] + slopes[static_cast<std::size_t>(j)];
      sum -= other.value[Line::volume] * slope.dot(x) * kernel_.slope_over_q(x.norm() * inverse);
    }
    return over_length(inverse, D + 2) * sum;
  }

  [[gnu::flatten]] FluidSpread<D> spread(Lines lines, Index i, std::span<const Index> neighbours,
                                         double smoothing_length, double mass,
                                         double spacing) const override {
    const double inverse = 1 / smoothing_length;
    const Line& receiver = lines[static_cast<std::size_t>(i)];
    const double density = mass / receiver.value[Line::volume];
    const double at_spacing = 1 / kernel_.value(spacing * inverse);
    Lanes moment[D][D], crowding[D], velocity[D][D], densities[D];
    for (int d = 0; d < D; ++d) {
      crowding[d] = densities[d] = 0;
      for (int e = 0; e < D; ++e) moment[d][e] = velocity[d][e] = 0;
    }
    for_each_eight<D>(lines, i, neighbours, [&](const LineLanes& lanes, std::size_t) {
      const EightPairs<D> pair(receiver, lanes, inverse);
      const Lanes f = slope_over_q_of(kernel_, pair.q);
      const Lanes vf = f * lanes[Line::volume];
      const Lanes ratio = value_of(kernel_, pair.q) * at_spacing, square = ratio * ratio;
      const Lanes crowd = vf * (1 + 0.2 * square * square);
      const Lanes drop = f * (mass - density * lanes[Line::volume]);
      for (int d = 0; d < D; ++d) {
        crowding[d] += crowd * pair.x[d];
        densities[d] += drop * pair.x[d];
        const Lanes vfx = vf * pair.x[d];
        for (int e = 0; e < D; ++e) {
          moment[d][e] += vfx * pair.x[e];
          velocity[e][d] += vfx * (lanes[Line::velocity + e] - receiver.value[Line::velocity + e]);
        }
      }
    });
    FluidSpread<D> spread;
    const double scale = over_length(inverse, D + 2);
    for (int d = 0; d < D; ++d) {
      spread.crowding[d] = scale * sum_of(crowding[d]);
      spread.density[d] = scale * sum_of(densities[d]);
      for (int e = 0; e < D; ++e) {
        spread.moment(d, e) = -scale * sum_of(moment[d][e]);
        spread.velocity(d, e) = scale * sum_of(velocity[d][e]);
      }
    }
    return spread;
  }

 private:
  static constexpr Index block_size = 128;

  static double over_length(double inverse, int times) {
    double product = 1;
    for (int k = 0; k < times; ++k) product *= inverse;
    return product;
  }

  /// The sums of one receiver, common factors outside:
  ///   D rho/Dt = rho_i h^-(D+2) sum f [V_j (u.x + 2 delta h c - b.x) - 2 delta h c V_i],
  /// with F = f h^-(D+2) and b = 2 delta h c/rho_i grad rho_rest.
  [[gnu::flatten]] void add_up_one(Lines lines, Index i, std::span<const Index> neighbours,
                                   double smoothing_length, const FluidCoefficients<D>& c,
                                   const FluidRates<D>& rates, FluidPass& pass) const {
    const Line receiver = lines[static_cast<std::size_t>(i)];
    const double inverse = 1 / smoothing_length, support = kernel_.support() * rim_tolerance;
    const double volume = receiver.value[Line::volume], density = c.mass / volume;
    const double pressure = receiver.value[Line::pressure];
    const double softening = 0.01 * smoothing_length * smoothing_length;
    const double diffusion = 2 * c.diffusion, diffusing = diffusion * volume;
    const Vec<D> at_rest = diffusion / density * c.density_at_rest;
    const bool rests = !at_rest.isZero(0), sticks = c.viscosity != 0;
    const bool pressed = c.pressure, carried = c.continuity;
    const double artificial = c.artificial_viscosity, drag = 2 * c.viscosity;
    Lanes acceleration[D], rate = 0, lost = 0;
    for (int d = 0; d < D; ++d) acceleration[d] = 0;
    std::int64_t pairs = 0;
    for_each_eight<D>(
        lines, i,
        neighbours, [&](const LineLanes& lanes, std::size_t valid) __attribute__((always_inline)) {
          const EightPairs<D> pair(receiver, lanes, inverse);
          pairs += static_cast<int>(valid) - popcount(pair.q > support);
          const Lanes f = slope_over_q_of(kernel_, pair.q);
          const Lanes vf = f * lanes[Line::volume];
          Lanes u[D];
          for (int d = 0; d < D; ++d)
            u[d] = receiver.value[Line::velocity + d] - lanes[Line::velocity + d];
          Lanes approach = u[0] * pair.x[0];
          for (int d = 1; d < D; ++d) approach = approach + u[d] * pair.x[d];
          Lanes flow = diffusion;
          if (carried) flow = approach + diffusion;
          if (rests)
            for (int d = 0; d < D; ++d) flow = flow - at_rest[d] * pair.x[d];
          rate = rate + (vf * flow - f * diffusing);
          Lanes along = 0;
          if (pressed) along = -(pressure + lanes[Line::pressure]);
          if (artificial != 0) {
            Lanes brake = approach / (pair.squared + softening);
            where(approach > 0, brake) = 0;
            brake = artificial * brake;
            along = along + brake;
            lost = lost + vf * brake * approach;
          }
          const Lanes force = vf * along;
          for (int d = 0; d < D; ++d) acceleration[d] = acceleration[d] + force * pair.x[d];
          if (sticks)
            for (int d = 0; d < D; ++d) {
              const Lanes pull = drag * vf * u[d];
              acceleration[d] = acceleration[d] + pull;
              lost = lost + pull * u[d];
            }
        });
    const double scale = over_length(inverse, D + 2);
    for (int d = 0; d < D; ++d)
      rates.acceleration[static_cast<std::size_t>(i) * D + static_cast<std::size_t>(d)] =
          scale / density * sum_of(acceleration[d]);
    rates.density_rate[i] = scale * density * sum_of(rate);
    pass.pairs += pairs;
    // Every pair is met from both its ends, and slopes are negative.
    pass.dissipation -= 0.5 * scale * volume * sum_of(lost);
  }

  Kernel kernel_;
  mutable std::vector<FluidPass> passes_;  ///< of every block; work for one `add_up` at a time
};

}  // namespace mote
