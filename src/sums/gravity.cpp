#include "mote/sums/gravity.hpp"

#include "mote/sums/gravity_kernels.hpp"
#include "mote/sums/pair_sum.hpp"
#include "mote/sums/plane_fields.hpp"
#include "mote/sums/space_fields.hpp"
#include "mote/sums/sum_checks.hpp"

namespace mote {

/// The sum for one core, chosen by name once.
template <int D>
class Gravity<D>::Sum {
 public:
  virtual ~Sum() = default;

  static std::unique_ptr<Sum> of(const SumSettings& settings, std::string_view core) {
    std::unique_ptr<Sum> sum;
    visit_shape<D>(core, [&]<class Shape>() { sum = std::make_unique<OfShape<Shape>>(settings); });
    return sum;
  }

  /// Of all sources, also of one on the target's own place.
  virtual void form(std::span<const double> targets, const Sources<D>& sources,
                    const GravityField& result) = 0;
  /// Takes from the potential at every source what it does to itself.
  virtual void take_own_part(const Sources<D>& sources, std::span<double> potential) const = 0;
  virtual bool is_of_points() const = 0;

 private:
  template <class Shape>
  class OfShape;
};

template <int D>
template <class Shape>
class Gravity<D>::Sum::OfShape final : public Gravity<D>::Sum {
 public:
  explicit OfShape(const SumSettings& settings)
      : tolerance_(settings.tolerance),
        pairs_(settings.method, [&] { return expansion(settings.tolerance); }) {}

  void form(std::span<const double> targets, const Sources<D>& sources,
            const GravityField& result) override {
    pairs_.place(targets, sources);
    if (result.potential.empty())
      form_part<GravityPart::gradient>(sources.core_size);
    else if (result.gradient.empty())
      form_part<GravityPart::potential>(sources.core_size);
    else
      form_part<GravityPart::both>(sources.core_size);
    const int before_gradient = result.potential.empty() ? 0 : 1;
    if (!result.potential.empty()) pairs_.give(0, 1, result.potential);
    if (!result.gradient.empty()) pairs_.give(before_gradient, D, result.gradient);
  }

  void take_own_part(const Sources<D>& sources, std::span<double> potential) const override {
    const auto shape = Shape::of_size(sources.core_size);
    const Lanes centre = at_distance(shape, 0).potential();
    const double own = D == 2 ? centre[0] : -centre[0];
    for (std::size_t i = 0; i < potential.size(); ++i) potential[i] -= sources.strength[i] * own;
  }

  bool is_of_points() const override { return !Shape::has_size; }

 private:
  static FarExpansion<D> expansion(double tolerance) {
    if constexpr (D == 2) return LaurentExpansion(tolerance, true);
    if constexpr (D == 3) return SpaceExpansion(tolerance, 1);
  }

  template <GravityPart Part>
  void form_part(double core_size) {
    const auto shape = Shape::of_size(core_size);
    pairs_.form(GravityKernel<Shape, Part>{shape}, shape, tolerance_);
  }

  double tolerance_;
  PairSum<D> pairs_;
};

template <int D>
Gravity<D>::Gravity(const SumSettings& settings, std::string_view core) {
  check_settings(settings, "gravity");
  sum_ = Sum::of(settings, core);
}

template <int D>
Gravity<D>::~Gravity() = default;

template <int D>
void Gravity<D>::at_sources(const Sources<D>& sources, const GravityField& result) {
  if (!sum_->is_of_points()) check_core_size(sources.core_size);
  sum_->form(sources.position, sources, result);
  sum_->take_own_part(sources, result.potential);
}

template <int D>
void Gravity<D>::at(std::span<const double> targets, const Sources<D>& sources,
                    const GravityField& result) {
  check_targets(targets, sources, sum_->is_of_points());
  sum_->form(targets, sources, result);
}

template class Gravity<2>;
template class Gravity<3>;

}  // namespace mote
