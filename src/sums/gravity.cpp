#include "mote/sums/gravity.hpp"

#include "mote/sums/direct_sum.hpp"
#include "mote/sums/gravity_kernels.hpp"
#include "mote/sums/sum_checks.hpp"

namespace mote {

/// The sum for one core, chosen by name once.
template <int D>
class Gravity<D>::Sum {
 public:
  virtual ~Sum() = default;

  static std::unique_ptr<Sum> of(std::string_view core) {
    std::unique_ptr<Sum> sum;
    visit_shape<D>(core, [&]<class Shape>() { sum = std::make_unique<OfShape<Shape>>(); });
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
  void form(std::span<const double> targets, const Sources<D>& sources,
            const GravityField& result) override {
    const auto shape = Shape::of_size(sources.core_size);
    direct_.place(targets, sources);
    if (result.potential.empty())
      direct_.sums(GravityKernel<Shape, GravityPart::gradient>{shape}).give(0, D, result.gradient);
    else if (result.gradient.empty())
      direct_.sums(GravityKernel<Shape, GravityPart::potential>{shape})
          .give(0, 1, result.potential);
    else
      form_both(shape, result);
  }

  void take_own_part(const Sources<D>& sources, std::span<double> potential) const override {
    const Lanes centre = Shape::of_size(sources.core_size).potential(Lanes(0));
    const double own = D == 2 ? centre[0] : -centre[0];
    for (std::size_t i = 0; i < potential.size(); ++i) potential[i] -= sources.strength[i] * own;
  }

  bool is_of_points() const override { return !Shape::has_size; }

 private:
  void form_both(const Shape& shape, const GravityField& result) {
    const auto& sums = direct_.sums(GravityKernel<Shape, GravityPart::both>{shape});
    sums.give(0, 1, result.potential);
    sums.give(1, D, result.gradient);
  }

  DirectSum<D> direct_;
};

template <int D>
Gravity<D>::Gravity(const SumSettings& settings, std::string_view core) {
  check_settings(settings, "gravity");
  sum_ = Sum::of(core);
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
  if (sum_->is_of_points())
    refuse_targets_on_sources<D>(targets, sources.position);
  else
    check_core_size(sources.core_size);
  sum_->form(targets, sources, result);
}

template class Gravity<2>;
template class Gravity<3>;

}  // namespace mote
