#include "mote/sums/biot_savart.hpp"

#include <numbers>

#include "mote/sums/biot_savart_kernels.hpp"
#include "mote/sums/direct_sum.hpp"
#include "mote/sums/sum_checks.hpp"

namespace mote {

/// The sum for one core, chosen by name once.
template <int D>
class BiotSavart<D>::Sum {
 public:
  virtual ~Sum() = default;

  static std::unique_ptr<Sum> of(std::string_view core) {
    std::unique_ptr<Sum> sum;
    visit_shape<D>(core, [&]<class Shape>() { sum = std::make_unique<OfShape<Shape>>(); });
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
  void form(std::span<const double> targets, const Sources<D>& sources,
            const VelocityField& result) override {
    constexpr double scale = 1 / ((D == 2 ? 2 : 4) * std::numbers::pi);
    const auto shape = Shape::of_size(sources.core_size);
    direct_.place(targets, sources, scale);
    if (result.gradient.empty()) {
      direct_.sums(VortexKernel<Shape, false>{shape}).give(0, D, result.velocity);
    } else {
      const auto& sums = direct_.sums(VortexKernel<Shape, true>{shape});
      sums.give(0, D, result.velocity);
      sums.give(D, D * D, result.gradient);
    }
  }

  bool is_of_points() const override { return !Shape::has_size; }

 private:
  DirectSum<D> direct_;
};

template <int D>
BiotSavart<D>::BiotSavart(const SumSettings& settings, std::string_view core) {
  check_settings(settings, "biot_savart");
  sum_ = Sum::of(core);
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
  if (sum_->is_of_points())
    refuse_targets_on_sources<D>(targets, sources.position);
  else
    check_core_size(sources.core_size);
  sum_->form(targets, sources, result);
}

template class BiotSavart<2>;
template class BiotSavart<3>;

}  // namespace mote
