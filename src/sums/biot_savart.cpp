#include "mote/sums/biot_savart.hpp"

#include <numbers>

#include "mote/sums/biot_savart_kernels.hpp"
#include "mote/sums/pair_sum.hpp"
#include "mote/sums/plane_fields.hpp"
#include "mote/sums/space_fields.hpp"
#include "mote/sums/sum_checks.hpp"

namespace mote {

/// The sum for one core, chosen by name once.
template <int D>
class BiotSavart<D>::Sum {
 public:
  virtual ~Sum() = default;

  static std::unique_ptr<Sum> of(const SumSettings& settings, std::string_view core) {
    std::unique_ptr<Sum> sum;
    visit_shape<D>(core, [&]<class Shape>() { sum = std::make_unique<OfShape<Shape>>(settings); });
    return sum;
  }

  virtual void form(std::span<const double> targets, const Sources<D>& sources,
                    const VelocityField& result) = 0;
  virtual bool is_of_points() const = 0;

 private:
  template <class Shape>
  class OfShape;
};

template <int D>
template <class Shape>
class BiotSavart<D>::Sum::OfShape final : public BiotSavart<D>::Sum {
 public:
  explicit OfShape(const SumSettings& settings)
      : tolerance_(settings.tolerance),
        pairs_(settings.method, [&] { return expansion(settings.tolerance); }) {}

  void form(std::span<const double> targets, const Sources<D>& sources,
            const VelocityField& result) override {
    constexpr double scale = 1 / ((D == 2 ? 2 : 4) * std::numbers::pi);
    const auto shape = Shape::of_size(sources.core_size);
    pairs_.place(targets, sources, scale);
    if (result.gradient.empty()) {
      pairs_.form(VortexKernel<Shape, false>{shape}, shape, tolerance_);
    } else {
      pairs_.form(VortexKernel<Shape, true>{shape}, shape, tolerance_);
      pairs_.give(D, D * D, result.gradient);
    }
    pairs_.give(0, D, result.velocity);
  }

  bool is_of_points() const override { return !Shape::has_size; }

 private:
  static FarExpansion<D> expansion(double tolerance) {
    if constexpr (D == 2) return LaurentExpansion(tolerance, false);
    if constexpr (D == 3) return SpaceExpansion(tolerance, 3);
  }

  double tolerance_;
  PairSum<D> pairs_;
};

template <int D>
BiotSavart<D>::BiotSavart(const SumSettings& settings, std::string_view core) {
  check_settings(settings, "biot_savart");
  sum_ = Sum::of(settings, core);
}

template <int D>
BiotSavart<D>::~BiotSavart() = default;

template <int D>
void BiotSavart<D>::at_sources(const Sources<D>& sources, const VelocityField& result) {
  if (!sum_->is_of_points()) check_core_size(sources.core_size);
  sum_->form(sources.position, sources, result);
}

template <int D>
void BiotSavart<D>::at(std::span<const double> targets, const Sources<D>& sources,
                       const VelocityField& result) {
  check_targets(targets, sources, sum_->is_of_points());
  sum_->form(targets, sources, result);
}

template class BiotSavart<2>;
template class BiotSavart<3>;

}  // namespace mote
