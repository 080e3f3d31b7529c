#include "mote/sums/biot_savart.hpp"

#include <cmath>
#include <numbers>

#include "mote/particles/parallel.hpp"

namespace mote {

template <int D>
class BiotSavart<D>::Sum {
 public:
  bool gauss;
};

template <int D>
BiotSavart<D>::BiotSavart(const SumSettings&, std::string_view core)
    : sum_(new Sum{core == "gauss"}) {}

template <int D>
BiotSavart<D>::~BiotSavart() = default;

template <int D>
void BiotSavart<D>::at_sources(const Sources<D>& s, const VelocityField& result) {
  const auto n = static_cast<Index>(s.strength.size());
  const double c2 = s.core_size * s.core_size, pi2 = 2 * std::numbers::pi;
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < n; ++i) {
    double u = 0, v = 0, g[4] = {0, 0, 0, 0};
    for (Index j = 0; j < n; ++j) {
      const double x = s.position[2 * i] - s.position[2 * j];
      const double y = s.position[2 * i + 1] - s.position[2 * j + 1];
      const double r2 = x * x + y * y;
      const double G = s.strength[j] / pi2;
      double f = 0, f2 = 0;  // f = q/r^2 , f2 = df/d(r^2)
      if (r2 == 0) {
        f = sum_->gauss ? 0.5 / c2 : 0;
      } else {
        const double e = sum_->gauss && r2 < 80 * c2 ? std::exp(-0.5 * r2 / c2) : 0;
        f = (1 - e) / r2;
        f2 = e > 0 ? e * 0.5 / c2 / r2 - f / r2 : -f / r2;
      }
      u -= G * f * y;
      v += G * f * x;
      if (!result.gradient.empty()) {
        g[0] -= G * 2 * x * y * f2;
        g[1] -= G * (f + 2 * y * y * f2);
        g[2] += G * (f + 2 * x * x * f2);
        g[3] += G * 2 * x * y * f2;
      }
    }
    result.velocity[2 * i] = u;
    result.velocity[2 * i + 1] = v;
    if (!result.gradient.empty())
      for (int k = 0; k < 4; ++k) result.gradient[4 * i + k] = g[k];
  }
}

template <int D>
void BiotSavart<D>::at(std::span<const double>, const Sources<D>&, const VelocityField&) {}

template class BiotSavart<2>;

}  // namespace mote
