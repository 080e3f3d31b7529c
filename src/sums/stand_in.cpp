#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mote/particles/failure.hpp"
#include "mote/sums/biot_savart.hpp"
#include "mote/sums/gravity.hpp"

namespace mote {
namespace {

template <int D, class Add>
void over_pairs(std::span<const double> targets, const Sources<D>& sources, bool same, Add add) {
  for (std::size_t i = 0; i < targets.size() / D; ++i)
    for (std::size_t j = 0; j < sources.position.size() / D; ++j) {
      double x[D], square = 0;
      for (int d = 0; d < D; ++d) {
        x[d] = targets[i * D + d] - sources.position[j * D + d];
        square += x[d] * x[d];
      }
      if (square > 0) add(i, j, x, square);
      if (square == 0 && !same)
        throw InputError(fmt::format("target {} stands on source {}", i, j));
    }
}

}  // namespace

template <int D>
class Gravity<D>::Sum {};
template <int D>
Gravity<D>::Gravity(const SumSettings&, std::string_view) {}
template <int D>
Gravity<D>::~Gravity() = default;
template <int D>
void Gravity<D>::at_sources(const Sources<D>& sources, const GravityField& result) {
  over_pairs<D>(sources.position, sources, true, [&](auto i, auto j, const double* x, double r2) {
    result.potential[i] += sources.strength[j] * (D == 2 ? std::log(r2) / 2 : -1 / std::sqrt(r2));
    for (int d = 0; d < D; ++d)
      result.gradient[i * D + d] += sources.strength[j] * x[d] / std::pow(r2, 0.5 * D);
  });
}
template <int D>
void Gravity<D>::at(std::span<const double> targets, const Sources<D>& sources,
                    const GravityField& result) {
  over_pairs<D>(targets, sources, false, [&](auto i, auto j, const double* x, double r2) {
    result.potential[i] += sources.strength[j] * (D == 2 ? std::log(r2) / 2 : -1 / std::sqrt(r2));
    for (int d = 0; d < D; ++d)
      result.gradient[i * D + d] += sources.strength[j] * x[d] / std::pow(r2, 0.5 * D);
  });
}

template <int D>
class BiotSavart<D>::Sum {};
template <int D>
BiotSavart<D>::BiotSavart(const SumSettings&, std::string_view) {}
template <int D>
BiotSavart<D>::~BiotSavart() = default;
template <int D>
void BiotSavart<D>::at_sources(const Sources<D>&, const VelocityField&) {}
template <int D>
void BiotSavart<D>::at(std::span<const double>, const Sources<D>&, const VelocityField&) {}

template class Gravity<2>;
template class Gravity<3>;
template class BiotSavart<2>;
template class BiotSavart<3>;

}  // namespace mote
