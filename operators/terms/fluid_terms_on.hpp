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

  explicit FluidTermsOn(const Kernel& kernel = Kernel()) : kernel_(kernel) {}

  double support() const override { return kernel_.support(); }

  FluidPass add_up(Lines lines, const NeighbourLists& lists, const PairOrder& order,
                   const FluidCoefficients<D>& coefficients,
                   std::span<PairSums> sums) const override {
    passes_.assign(order.blocks(), {});
    const Loop loop(lines, lists.receivers(), coefficients, sums.data());
    order.for_each_block([&](Index block, Index begin, Index end) {
      FluidPass& pass = passes_[static_cast<std::size_t>(block)];
      for (Index i = begin; i < end; ++i) add_pairs(loop, i, later_neighbours(lists, i), pass);
    });
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
    for_each_eight<D>(lines, i, neighbours,
                      [&](const LineLanes& lanes, const EightNeighbours& eight) {
                        sum += value_of(kernel_, EightPairs<D>(receiver, lanes, inverse).q);
                        missing = lane_count - eight.valid;
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
    for_each_eight<D>(
        lines, i, neighbours, [&](const LineLanes& lanes, const EightNeighbours& eight) {
          const EightPairs<D> pair(receiver, lanes, inverse);
          Lanes w = value_of(kernel_, pair.q);
          for (std::size_t lane = eight.valid; lane < lane_count; ++lane) w[lane] = 0;
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
    for_each_eight<D>(lines, i, neighbours, [&](const LineLanes& lanes, const EightNeighbours&) {
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
  static double over_length(double inverse, int times) {
    double product = 1;
    for (int k = 0; k < times; ++k) product *= inverse;
    return product;
  }

  /// What all pairs of a pass have in common.
  struct Loop {
    Lines lines;
    Index receivers;
    PairSums* sums;
    double mass, inverse, scale, softening, artificial, drag, diffusion;
    Vec<D> at_rest;  ///< gradient of the density at rest
    bool carried, pressed, rests, diffuses, brakes, drags;

    Loop(Lines all, Index firsts, const FluidCoefficients<D>& c, PairSums* of_all)
        : lines(all),
          receivers(firsts),
          sums(of_all),
          mass(c.mass),
          inverse(1 / c.smoothing_length),
          scale(over_length(inverse, D + 2)),
          softening(0.01 * c.smoothing_length * c.smoothing_length),
          artificial(c.artificial_viscosity),
          drag(2 * c.viscosity),
          diffusion(2 * c.diffusion),
          at_rest(c.density_at_rest),
          carried(c.continuity),
          pressed(c.pressure),
          rests(!c.density_at_rest.isZero(0)),
          diffuses(c.diffusion != 0),
          brakes(c.artificial_viscosity != 0),
          drags(c.viscosity != 0) {}
  };

  /// Adds the pairs of one point. Those with images, which are no receivers, are met again from
  /// the receiver's side by the image's owner, and so count half.
  [[gnu::flatten]] void add_pairs(const Loop& loop, Index i, std::span<const Index> neighbours,
                                  FluidPass& pass) const {
    const auto images = loop.lines.size() == static_cast<std::size_t>(loop.receivers)
                            ? neighbours.end()
                            : std::ranges::lower_bound(neighbours, loop.receivers);
    const std::span<const Index> parts[] = {{neighbours.begin(), images},
                                            {images, neighbours.end()}};
    for (int part = 0; part < 2; ++part) {
      if (parts[part].empty()) continue;
      const FluidPass found = add_some_pairs(loop, i, parts[part]);
      pass.pairs += (2 - part) * found.pairs;
      pass.dissipation += found.dissipation / (1 + part);
    }
  }

  /// Adds up  Du/Dt = V_i/m sum V_j F [...]  and
  ///   D ln rho/Dt = sum F [V_j u.x + 2 delta h c (V_j - V_i) - 2 delta h c V_i V_j x.grad
  ///   rho_rest/m].
  [[gnu::flatten]] FluidPass add_some_pairs(const Loop& loop, Index i,
                                            std::span<const Index> neighbours) const {
    const Loop all = loop;
    const Line receiver = all.lines[static_cast<std::size_t>(i)];
    const double volume = receiver.value[Line::volume], pressure = receiver.value[Line::pressure];
    const double share = volume / all.mass;
    Lanes force[D], rate = 0, lost = 0, near = 0;
    for (int d = 0; d < D; ++d) force[d] = 0;
    FluidPass pass;
    for_each_eight<D>(
        all.lines, i, neighbours,
        [&](const LineLanes& lanes, const EightNeighbours& eight) __attribute__((always_inline)) {
          const EightPairs<D> pair(receiver, lanes, all.inverse);
          where(pair.q <= kernel_.support() * rim_tolerance, near) += 1;
          const Lanes f = all.scale * slope_over_q_of(kernel_, pair.q);
          const Lanes both = share * lanes[Line::volume] * f;
          Lanes u[D];
          for (int d = 0; d < D; ++d)
            u[d] = receiver.value[Line::velocity + d] - lanes[Line::velocity + d];
          Lanes approach = u[0] * pair.x[0];
          for (int d = 1; d < D; ++d) approach = approach + u[d] * pair.x[d];

          Lanes exchange = 0;
          if (all.diffuses) {
            exchange = f * (lanes[Line::volume] - volume);
            if (all.rests)
              for (int d = 0; d < D; ++d) exchange = exchange - both * (all.at_rest[d] * pair.x[d]);
            exchange = all.diffusion * exchange;
          }
          std::array<Lanes, 4> sent{0, 0, 0, exchange};
          if (all.carried) {
            const Lanes compression = f * approach;
            rate = rate + compression * lanes[Line::volume];
            sent[PairSums::rate] = exchange - compression * volume;
          }
          rate = rate + exchange;

          Lanes along = 0;
          if (all.pressed) along = pressure + lanes[Line::pressure];
          if (all.brakes) {
            Lanes brake = approach / (pair.squared + all.softening);
            where(approach > 0, brake) = 0;
            brake = all.artificial * brake;
            along = along - brake;
            lost = lost + both * brake * approach;
          }
          along = along * -both;
          for (int d = 0; d < D; ++d) sent[d] = along * pair.x[d];
          if (all.drags)
            for (int d = 0; d < D; ++d) {
              const Lanes pull = all.drag * both * u[d];
              sent[d] = sent[d] + pull;
              lost = lost + pull * u[d];
            }
          for (int d = 0; d < D; ++d) force[d] = force[d] + sent[d];
          take_from(all.sums, eight.number, sent);
        });
    PairSums& sum = all.sums[i];
    for (int d = 0; d < D; ++d) sum.value[d] += sum_of(force[d]);
    sum.value[PairSums::rate] += sum_of(rate);
    // Where lanes were left free, the receiver was near to itself.
    pass.pairs =
        std::lround(sum_of(near)) -
        static_cast<std::int64_t>(packs_for(neighbours.size()) * lane_count - neighbours.size());
    // Slopes are negative.
    pass.dissipation = -all.mass * sum_of(lost);
    return pass;
  }

  Kernel kernel_;
  mutable std::vector<FluidPass> passes_;  ///< of every block; work for one `add_up` at a time
};

}  // namespace mote
