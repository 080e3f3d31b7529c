#include "mote/models/induced_velocity.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "mote/models/fixed_sum.hpp"
#include "mote/particles/failure.hpp"
#include "mote/sums/gravity.hpp"
#include "mote/sums/periodic_vortices.hpp"

namespace mote {
namespace {

/// In an unbounded fluid.
template <int D>
class FreeVortices final : public InducedVelocity<D> {
 public:
  explicit FreeVortices(const SumChoice& choice) : sums_(choice, few) {}

  void at_sources(const Sources<D>& sources, const VelocityField& result) override {
    sum_for(sources).velocity.at_sources(sources, result);
  }

  /// The curl of the velocity.
  void vorticity_at_sources(const Sources<D>& sources, std::span<double> vorticity) override {
    velocity_.resize(sources.position.size());
    gradient_.resize(sources.position.size() * D);
    sum_for(sources).velocity.at_sources(sources, {velocity_, gradient_});
    for (std::size_t i = 0; i < vorticity.size(); ++i) {
      const double* const slope = gradient_.data() + i / components * (D * D);
      if constexpr (D == 2) {
        vorticity[i] = slope[2] - slope[1];
      } else {
        const std::size_t b = (i + 1) % 3, c = (i + 2) % 3;  // i % 3 is the component
        vorticity[i] = slope[3 * c + b] - slope[3 * b + c];
      }
    }
  }

  /// The stream function is that of masses: -1/(2 pi) sum_j Gamma_j ln r, and in space for each
  /// component 1/(4 pi) sum_j alpha_j/r.
  std::optional<double> hamiltonian(const Sources<D>& sources) override {
    const std::size_t count = sources.position.size() / D;
    potential_.resize(count);
    component_.resize(count);
    double sum = 0;
    for (std::size_t c = 0; c < components; ++c) {
      for (std::size_t i = 0; i < count; ++i) component_[i] = sources.strength[i * components + c];
      sum_for(sources).potential.at_sources({sources.position, component_, sources.core_size},
                                            {potential_, {}});
      sum += fixed_sum(static_cast<Index>(count), 0.0, [&](Index i) {
        return component_[static_cast<std::size_t>(i)] * potential_[static_cast<std::size_t>(i)];
      });
    }
    return -sum / ((D == 2 ? 4 : 8) * std::numbers::pi);
  }

 private:
  static constexpr std::size_t components = D == 2 ? 1 : 3;

  struct Sums {
    Sums(const SumSettings& settings, const std::string& core)
        : velocity(settings, core), potential(settings, core) {}
    BiotSavart<D> velocity;
    Gravity<D> potential;
  };

  Sums& sum_for(const Sources<D>& sources) { return sums_.of(sources.position.size() / D); }

  static constexpr std::size_t few = 1500;

  ChosenSum<Sums> sums_;
  std::vector<double> velocity_, gradient_, potential_, component_;  ///< work
};

/// In a box with all images.
class BoxedVortices final : public InducedVelocity<2> {
 public:
  BoxedVortices(const SpaceStart& start, const std::string& core)
      : box_({start.upper[0] - start.lower[0], start.upper[1] - start.lower[1]}, core) {}

  void at_sources(const Sources<2>& sources, const VelocityField& result) override {
    box_.at_sources(sources, result.velocity);
  }
  void vorticity_at_sources(const Sources<2>& sources, std::span<double> vorticity) override {
    box_.vorticity_at_sources(sources, vorticity);
  }
  std::optional<double> hamiltonian(const Sources<2>& /*sources*/) override { return {}; }

 private:
  PeriodicVortices box_;
};

std::unique_ptr<InducedVelocity<2>> boxed(const SumChoice& options, const SpaceStart& start,
                                          std::ptrdiff_t axes) {
  if (axes != 2)
    throw InputError("domain.periodic",
                     "vortices need a domain that is periodic along all axes, or along none");
  if (options.method != "automatic")
    throw InputError("model.sum.method",
                     "a periodic box has a sum of its own, so 'method' has no effect");
  if (options.core != "point" && options.core != "gauss")
    throw InputError("model.core.name",
                     "vortices of a periodic box are points or have the core 'gauss'");
  return std::make_unique<BoxedVortices>(start, options.core);
}

}  // namespace

template <int D>
std::unique_ptr<InducedVelocity<D>> induced_velocity(const SumChoice& options,
                                                     const SpaceStart& start) {
  const auto axes = std::count(start.periodic.begin(), start.periodic.begin() + D, true);
  if (axes == 0) return std::make_unique<FreeVortices<D>>(options);
  if constexpr (D == 3)
    throw InputError("domain.periodic", "vortices in space need a fluid without bounds");
  else
    return boxed(options, start, axes);
}

template std::unique_ptr<InducedVelocity<3>> induced_velocity<3>(const SumChoice&,
                                                                 const SpaceStart&);
template std::unique_ptr<InducedVelocity<2>> induced_velocity<2>(const SumChoice&,
                                                                 const SpaceStart&);

}  // namespace mote
