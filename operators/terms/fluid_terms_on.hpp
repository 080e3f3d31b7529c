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

  FluidPass add_up(const PairPoints<D>& points, const NeighbourLists& lists, const PairOrder& order,
                   const FluidCoefficients<D>& coefficients,
                   std::span<PairSums> sums) const override {
    passes_.assign(order.blocks(), {});
    const Loop loop(points, coefficients);
    const bool images = points.lines.size() > static_cast<std::size_t>(lists.receivers());
    order.for_each_block([&](Index block, Index begin, Index end) {
      FluidPass& pass = passes_[static_cast<std::size_t>(block)];
      for (Index i = begin; i < end; ++i) {
        if (i + receivers_ahead < end) fetch_ahead(points, lists, i + receivers_ahead, sums);
        const auto later = later_neighbours(lists, i);
        const auto middle =
            images ? std::ranges::lower_bound(later, lists.receivers()) : later.end();
        add_pairs(loop, i, {later.begin(), middle}, false, sums, pass);
        add_pairs(loop, i, {middle, later.end()}, true, sums, pass);
      }
    });
    FluidPass all;
    for (const FluidPass& pass : passes_) {
      all.pairs += pass.pairs;
      all.dissipation += pass.dissipation;
    }
    return all;
  }

  PairSums sums_of(const PairPoints<D>& points, Index i, std::span<const Index> neighbours,
                   const FluidCoefficients<D>& coefficients) const override {
    return sum_up(Loop(points, coefficients), i, neighbours, nullptr).sums;
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
                                         const ClosePairs& close_pairs) const override {
    const double inverse = 1 / smoothing_length;
    const Line& receiver = lines[static_cast<std::size_t>(i)];
    const double density = mass / receiver.value[Line::volume];
    const double at_spacing = 1 / kernel_.value(close_pairs.spacing * inverse);
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
      const Lanes crowd = vf * (1 + close_pairs.weight * square * square);
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
  /// How many receivers ahead memory is asked for.
  static constexpr Index receivers_ahead = 8;

  static double over_length(double inverse, int times) {
    double product = 1;
    for (int k = 0; k < times; ++k) product *= inverse;
    return product;
  }

  /// What all pairs of a pass have in common.
  struct Loop {
    PairPoints<D> points;
    double mass, inverse, scale, softening, artificial, drag, diffusion;
    Vec<D> at_rest;  ///< gradient of the density at rest
    bool carried, pressed, rests, diffuses, brakes, drags;

    Loop(const PairPoints<D>& all, const FluidCoefficients<D>& c)
        : points(all),
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

  /// Asks for the memory of a receiver's last neighbours, which are the ones that receivers before
  /// it have not met: waiting for it costs a fifth of a pass over a million particles.
  static void fetch_ahead(const PairPoints<D>& points, const NeighbourLists& lists, Index i,
                          std::span<PairSums> sums) {
    const auto later = later_neighbours(lists, i);
    for (const Index j : later.last(std::min(later.size(), 2 * lane_count))) {
      const auto k = static_cast<std::size_t>(j);
      __builtin_prefetch(&points.lines[k]);
      if (k < sums.size()) __builtin_prefetch(&sums[k], 1);
    }
  }

  /// What the pairs of one point come to.
  struct Found {
    PairSums sums;
    FluidPass pass;
  };

  /// Pairs with images, which are no receivers, are met again where the image's owner meets one of
  /// this receiver.
  void add_pairs(const Loop& loop, Index i, std::span<const Index> neighbours, bool images,
                 std::span<PairSums> sums, FluidPass& pass) const {
    if (neighbours.empty()) return;
    const Found found = sum_up(loop, i, neighbours, images ? nullptr : sums.data());
    add(found.sums, sums[static_cast<std::size_t>(i)]);
    const int ends = images ? 1 : 2;
    pass.pairs += ends * found.pass.pairs;
    pass.dissipation += 0.5 * ends * found.pass.dissipation;
  }

  static void add(const PairSums& term, PairSums& sum) {
    for (std::size_t k = 0; k < sum.value.size(); ++k) sum.value[k] += term.value[k];
  }

  /// Halves the power that is lost to ghosts.
  static void halve_losses(const PairPoints<D>& points, Index i, const EightNeighbours& eight,
                           Lanes& lost) {
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      if (points.roles[static_cast<std::size_t>(i)] == PairRole::ghost ||
          points.roles[static_cast<std::size_t>(eight.number[lane])] == PairRole::ghost)
        lost[lane] *= 0.5;
  }

  /// u.x of the velocities at which mass moves, where one end is a ghost.
  static void let_carry(const PairPoints<D>& points, Index i, const EightNeighbours& eight,
                        const EightPairs<D>& pair, Lanes& approach) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const auto own = static_cast<std::size_t>(i);
      const auto other = static_cast<std::size_t>(eight.number[lane]);
      if (points.roles[own] != PairRole::ghost && points.roles[other] != PairRole::ghost) continue;
      const Vec<D> u = points.carrying_velocity(own) - points.carrying_velocity(other);
      double sum = 0;
      for (int d = 0; d < D; ++d) sum += u[d] * pair.x[d][static_cast<std::size_t>(lane)];
      approach[lane] = sum;
    }
  }

  /// Sums up  Du/Dt = V_i/m sum V_j F [...]  and
  ///   D ln rho/Dt = sum F [V_j u.x + 2 delta h c (V_j - V_i) - 2 delta h c V_i V_j x.grad
  ///   rho_rest/m]
  /// of point i, and takes what the other ends get from `others`, if these are given.
  [[gnu::flatten]] Found sum_up(const Loop& loop, Index i, std::span<const Index> neighbours,
                                PairSums* others) const {
    const Loop all = loop;
    const Line receiver = all.points.lines[static_cast<std::size_t>(i)];
    const double volume = receiver.value[Line::volume], pressure = receiver.value[Line::pressure];
    const double share = volume / all.mass;
    const bool ghosts = all.points.roles[static_cast<std::size_t>(i)] != PairRole::plain;
    Lanes force[D], rate = 0, lost = 0, near = 0;
    for (int d = 0; d < D; ++d) force[d] = 0;
    for_each_eight<D>(
        all.points.lines, i, neighbours,
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
            Lanes flow = approach;
            if (ghosts && !all.points.carrying.empty()) [[unlikely]]
              let_carry(all.points, i, eight, pair, flow);
            const Lanes compression = f * flow;
            rate = rate + compression * lanes[Line::volume];
            sent[PairSums::rate] = exchange - compression * volume;
          }
          rate = rate + exchange;

          Lanes along = 0, losses = 0;
          if (all.pressed) along = pressure + lanes[Line::pressure];
          if (all.brakes) {
            Lanes brake = approach / (pair.squared + all.softening);
            where(approach > 0, brake) = 0;
            brake = all.artificial * brake;
            along = along - brake;
            losses = both * brake * approach;
          }
          along = along * -both;
          for (int d = 0; d < D; ++d) sent[d] = along * pair.x[d];
          if (all.drags)
            for (int d = 0; d < D; ++d) {
              const Lanes pull = all.drag * both * u[d];
              sent[d] = sent[d] + pull;
              losses = losses + pull * u[d];
            }
          if (ghosts) [[unlikely]]
            halve_losses(all.points, i, eight, losses);
          lost = lost + losses;
          for (int d = 0; d < D; ++d) force[d] = force[d] + sent[d];
          if (others) take_from(others, eight.number, sent);
        });
    Found found;
    for (int d = 0; d < D; ++d) found.sums.value[d] = sum_of(force[d]);
    found.sums.value[PairSums::rate] = sum_of(rate);
    // Where lanes were left free, the receiver was near to itself.
    found.pass.pairs =
        std::lround(sum_of(near)) -
        static_cast<std::int64_t>(packs_for(neighbours.size()) * lane_count - neighbours.size());
    // Slopes are negative.
    found.pass.dissipation = -all.mass * sum_of(lost);
    return found;
  }

  Kernel kernel_;
  mutable std::vector<FluidPass> passes_;  ///< of every block; work for one `add_up` at a time
};

}  // namespace mote
