#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "mote/operators/cores/all.hpp"
#include "mote/sums/sum_settings.hpp"

namespace mote::test {

using Long = long double;

/// How a source of unit strength acts at a distance, plainly: q/r^D, its slope over r, potential.
struct LongShape {
  Long influence = 0, slope = 0, potential = 0;
};

/// Of a point, or of a core of the list (by its own functions, which have tests of their own).
template <int D>
LongShape long_shape(std::string_view core, double size, Long r) {
  if (core == "point") {
    if (r == 0) return {};
    return {1 / std::pow(r, Long(D)), -D / std::pow(r, Long(D + 2)), D == 2 ? std::log(r) : 1 / r};
  }
  LongShape shape;
  for_each_type(VortexCores{}, [&]<class Core>() {
    if (core != Core::name) return;
    const auto t = static_cast<double>(r * r / (Long(size) * size));
    const Long potential = Core::template potential<D>(t);
    shape = {Core::template influence<D>(t) / std::pow(Long(size), Long(D)),
             Core::template influence_slope<D>(t) / std::pow(Long(size), Long(D + 2)),
             D == 2 ? std::log(Long(size)) + potential : potential / size};
  });
  return shape;
}

/// Calls visit(i, j, x_i - x_j, shape) for all pairs, sources j in order.
template <int D, class Visit>
void for_each_long_pair(std::span<const double> targets, const Sources<D>& sources,
                        std::string_view core, Visit visit) {
  for (std::size_t i = 0; i < targets.size() / D; ++i)
    for (std::size_t j = 0; j < sources.position.size() / D; ++j) {
      std::array<Long, D> x;
      Long square = 0;
      for (int d = 0; d < D; ++d) {
        x[d] = Long(targets[i * D + d]) - sources.position[j * D + d];
        square += x[d] * x[d];
      }
      visit(i, j, x, long_shape<D>(core, sources.core_size, std::sqrt(square)));
    }
}

struct LongGravity {
  std::vector<Long> potential, gradient;
};

/// Potential and gradient of masses; `own` says whether source i acts on target i.
template <int D>
LongGravity long_gravity(std::span<const double> targets, const Sources<D>& sources,
                         std::string_view core, bool own) {
  LongGravity sum{std::vector<Long>(targets.size() / D), std::vector<Long>(targets.size())};
  for_each_long_pair<D>(targets, sources, core,
                        [&](std::size_t i, std::size_t j, const auto& x, const LongShape& shape) {
                          if (i == j && !own) return;
                          const Long mass = sources.strength[j];
                          sum.potential[i] += (D == 2 ? mass : -mass) * shape.potential;
                          for (int d = 0; d < D; ++d)
                            sum.gradient[i * D + d] += mass * shape.influence * x[d];
                        });
  return sum;
}

struct LongVelocity {
  std::vector<Long> velocity, gradient;
};

/// u = alpha x r f(r)/(2 pi or 4 pi), alpha = (0, 0, Gamma) in 2D, and
/// du_a/dx_b = e_acb alpha_c f + (alpha x r)_a r_b f'/r.
template <int D>
LongVelocity long_velocity(std::span<const double> targets, const Sources<D>& sources,
                           std::string_view core) {
  constexpr Long scale = 1 / ((D == 2 ? 2 : 4) * std::numbers::pi_v<Long>);
  const auto sign = [](int a, int b, int c) { return (b - a) * (c - a) * (c - b) / 2; };
  LongVelocity sum{std::vector<Long>(targets.size()), std::vector<Long>(targets.size() * D)};
  for_each_long_pair<D>(targets, sources, core,
                        [&](std::size_t i, std::size_t j, const auto& x, const LongShape& shape) {
                          Long alpha[3] = {0, 0, 0}, r[3] = {0, 0, 0};
                          for (int d = 0; d < D; ++d) r[d] = x[d];
                          if (D == 2) alpha[2] = sources.strength[j];
                          if (D == 3) std::copy_n(&sources.strength[3 * j], 3, alpha);
                          for (int a = 0; a < D; ++a) {
                            Long cross = 0;
                            for (int c = 0; c < 3; ++c)
                              for (int b = 0; b < 3; ++b) cross += sign(a, c, b) * alpha[c] * r[b];
                            sum.velocity[i * D + a] += scale * shape.influence * cross;
                            for (int b = 0; b < D; ++b) {
                              Long slope = shape.slope * cross * r[b];
                              for (int c = 0; c < 3; ++c)
                                slope += sign(a, c, b) * alpha[c] * shape.influence;
                              sum.gradient[(i * D + a) * D + b] += scale * slope;
                            }
                          }
                        });
  return sum;
}

}  // namespace mote::test
