#include "mote/sums/cauchy.hpp"

#include "mote/sums/pair_shapes.hpp"
#include "mote/sums/pair_sum.hpp"
#include "mote/sums/plane_fields.hpp"
#include "mote/sums/power_series.hpp"
#include "mote/sums/sum_checks.hpp"

namespace mote {
namespace {

/// v/(s - t).
struct CauchyKernel {
  static constexpr int dimension = 2, strengths = 2, outputs = 2;

  PointShape<2> shape;

  [[gnu::always_inline]] void add(const std::array<Lanes, 2>& difference,
                                  const std::array<double, 2>& strength,
                                  const PointShape<2>::At& at, std::array<Lanes, 2>& sums) const {
    const auto& [x, y] = difference;
    const Lanes inverse = at.influence();
    sums[0] = fused(fused(strength[0], x, strength[1] * y), inverse, sums[0]);
    sums[1] = fused(fused(strength[1], x, -(strength[0] * y)), inverse, sums[1]);
  }
};

std::span<const double> numbers(std::span<const Complex> values) {
  return {reinterpret_cast<const double*>(values.data()), 2 * values.size()};
}

}  // namespace

template <>
class FarField<CauchyKernel> : PlaneField {
 public:
  using PlaneField::PlaneField;

  void add(const std::array<Lanes, 2>& offset, std::array<Lanes, 2>& sums) const {
    const auto values = values_at(offset, false);
    sums[0] += values.real;
    sums[1] += values.imaginary;
  }
};

class Cauchy::Sum {
 public:
  explicit Sum(const SumSettings& settings)
      : settings(settings),
        pairs(settings.method, [&] { return LaurentExpansion(settings.tolerance, false); }) {}

  void form(std::span<const Complex> targets, std::span<const Complex> sources,
            std::span<const Complex> strengths, std::span<Complex> result) {
    pairs.place(numbers(targets), {numbers(sources), numbers(strengths)});
    pairs.form(CauchyKernel(), PointShape<2>(), settings.tolerance);
    pairs.give(0, 2, {reinterpret_cast<double*>(result.data()), 2 * result.size()});
  }

  SumSettings settings;
  PairSum<2> pairs;
};

Cauchy::Cauchy(const SumSettings& settings) {
  check_tolerance(settings);
  sum_ = std::make_unique<Sum>(settings);
}
Cauchy::~Cauchy() = default;

void Cauchy::at_sources(std::span<const Complex> points, std::span<const Complex> strengths,
                        std::span<Complex> result) {
  if (sum_->settings.method == SumMethod::power_series)
    throw InputError("method",
                     "power_series serves targets apart from the sources, not the sources "
                     "themselves; take direct or multipole");
  refuse_points_of_one_place<2>(numbers(points));
  sum_->form(points, points, strengths, result);
}

void Cauchy::at(std::span<const Complex> targets, std::span<const Complex> sources,
                std::span<const Complex> strengths, std::span<Complex> result) {
  if (sum_->settings.method == SumMethod::power_series)
    return power_series(targets, sources, strengths, sum_->settings.tolerance, result);
  refuse_targets_on_sources<2>(numbers(targets), numbers(sources));
  sum_->form(targets, sources, strengths, result);
}

}  // namespace mote
