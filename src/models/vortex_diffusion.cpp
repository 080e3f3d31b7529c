#include "mote/models/vortex_diffusion.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "mote/operators/differential/apply.hpp"
#include "mote/particles/failure.hpp"
#include "mote/particles/random.hpp"

namespace mote {
namespace {

using std::numbers::pi;

void note_work(const NeighbourLists& lists, PairWork& work) {
  work.pairs += lists.pairs();
  ++work.evaluations;
  work.mean_neighbours =
      static_cast<double>(lists.pairs()) / std::max<double>(1, lists.receivers());
}

/// Degond and Mas-Gallic (1989): with eta = exp(-(r/e)^2)/(sqrt(pi) e)^D, whose second moment along
/// each axis is e^2/2,
///   lap f = 4/e^2 int (f(y) - f(x)) eta(x - y) dy + O(e^2),
///   d Gamma_i/dt = 4 nu/e^2 sum_j (V_i Gamma_j - V_j Gamma_i) eta_ij.
/// What i gets from j is what j loses, to the last bit.
template <int D>
class Exchange final : public VortexDiffusion<D> {
 public:
  Exchange(const VortexOptions& options, const SpaceSetup& setup)
      : viscosity_(options.kinematic_viscosity),
        range_(options.exchange_range * setup.spacing),
        neighbours_(setup, setup.search, {.support = cut * options.exchange_range}) {}

  bool changes_circulation() const override { return true; }
  double longest_step() const override { return 0.5 * range_ * range_ / viscosity_; }
  PairWork pair_work() const override { return work_; }

  void find_rates(const VortexParticles<D>& vortices, std::span<double> rate) override {
    constexpr std::size_t strengths = VortexList<D>::strengths;
    neighbours_.find(vortices);
    note_work(neighbours_.lists(), work_);
    const double scale = 4 * viscosity_ / (range_ * range_) / std::pow(std::sqrt(pi) * range_, D);
    const auto volume = vortices.volume(), circulation = vortices.circulation();
#pragma omp parallel for schedule(static) if (parallel_from <= vortices.count())
    for (Index i = 0; i < vortices.count(); ++i) {
      const auto own = static_cast<std::size_t>(i);
      std::array<double, strengths> sum{};
      for (const Index k : neighbours_.lists()[i]) {
        const auto other = static_cast<std::size_t>(neighbours_.owner(k));
        const double squared =
            (neighbours_.points().at(i) - neighbours_.points().at(k)).squaredNorm();
        const double weight = std::exp(-squared / (range_ * range_));
        for (std::size_t c = 0; c < strengths; ++c)
          sum[c] += weight * (volume[own] * circulation[other * strengths + c] -
                              volume[other] * circulation[own * strengths + c]);
      }
      for (std::size_t c = 0; c < strengths; ++c) rate[own * strengths + c] = scale * sum[c];
    }
  }

 private:
  static constexpr double cut = 5;  ///< ranges: exp(-25) is next to nothing

  double viscosity_, range_;
  VortexNeighbours<D> neighbours_;
  PairWork work_;
};

/// d omega/dt = nu lap omega, (37) of Isshiki (2014), by the scenario's operator.
template <int D>
class OperatorDiffusion final : public VortexDiffusion<D> {
 public:
  OperatorDiffusion(const VortexOptions& options, SpaceSetup& setup)
      : viscosity_(options.kinematic_viscosity),
        floor_(options.floor),
        operator_(&dynamic_cast<DifferentialOperator<D>&>(*setup.differential_operator)),
        owner_(std::move(setup.differential_operator)),
        neighbours_(setup, setup.search, operator_->neighbour_rule()) {
    if (D == 3 && operator_->needs_circulation())
      throw InputError("operator",
                       "this operator weighs by circulation as one number, and in space it is a "
                       "vector: choose another one");
  }

  bool changes_circulation() const override { return true; }
  PairWork pair_work() const override { return work_; }

  void find_rates(const VortexParticles<D>& vortices, std::span<double> rate) override {
    neighbours_.find(vortices);
    note_work(neighbours_.lists(), work_);
    Points<D>& points = neighbours_.points();
    if (D == 2) show_circulation(vortices, points);
    exempt_weak_ones(vortices, points);
    operator_->prepare(points, neighbours_.lists());
    for_each_row<double>(neighbours_.lists(), [&](Index i, auto neighbours, auto weights) {
      const auto own = static_cast<std::size_t>(i);
      for (std::size_t c = 0; c < strengths; ++c) rate[own * strengths + c] = 0;
      if (!points.needs_weights(i)) return;
      operator_->laplacian_weights(i, weights);
      for (std::size_t c = 0; c < strengths; ++c) {
        double sum = 0;
        for (std::size_t k = 0; k < neighbours.size(); ++k)
          sum += weights[k] *
                 (vortices.density(static_cast<std::size_t>(neighbours_.owner(neighbours[k])), c) -
                  vortices.density(own, c));
        rate[own * strengths + c] = viscosity_ * vortices.volume()[own] * sum;
      }
    });
  }

 private:
  static constexpr std::size_t strengths = VortexList<D>::strengths;

  void show_circulation(const VortexParticles<D>& vortices, Points<D>& points) const {
    for (std::size_t k = 0; k < points.vorticity.size(); ++k) {
      const auto i = static_cast<std::size_t>(neighbours_.owner(static_cast<Index>(k)));
      points.circulation[k] = vortices.circulation()[i];
      points.vorticity[k] = vortices.density(i);
    }
  }

  void exempt_weak_ones(const VortexParticles<D>& vortices, Points<D>& points) const {
    const double highest = vortices.highest_density();
    points.exempt.resize(static_cast<std::size_t>(points.receivers));
    for (std::size_t i = 0; i < points.exempt.size(); ++i)
      points.exempt[i] = vortices.strength(i) / vortices.volume()[i] <= floor_ * highest ? 1 : 0;
  }

  double viscosity_, floor_;
  DifferentialOperator<D>* operator_;
  std::unique_ptr<AnyOperator> owner_;
  VortexNeighbours<D> neighbours_;
  PairWork work_;
};

/// The heat kernel of a gauss core is a gauss core: size^2 grows by 2 nu t.
template <int D>
class CoreSpreading final : public VortexDiffusion<D> {
 public:
  explicit CoreSpreading(const VortexOptions& options) : viscosity_(options.kinematic_viscosity) {}
  double core_growth() const override { return 2 * viscosity_; }

 private:
  double viscosity_;
};

/// Chorin (1973): normal steps of variance 2 nu t along each axis.
template <int D>
class RandomWalk final : public VortexDiffusion<D> {
 public:
  explicit RandomWalk(const VortexOptions& options)
      : viscosity_(options.kinematic_viscosity), seed_(static_cast<std::uint64_t>(options.seed)) {}

  void end_step(VortexParticles<D>& vortices, double time, double step) override {
    // A stream of its own for each step, by the bits of its time: a restart knows it.
    const double draw = uniform_random(seed_, std::bit_cast<std::uint64_t>(time));
    const std::uint64_t stream = std::bit_cast<std::uint64_t>(draw) * 0xD1342543DE82EF95u;
    const double length = std::sqrt(2 * viscosity_ * step);
    const auto position = vortices.position();
    const auto size = static_cast<std::ptrdiff_t>(position.size());
#pragma omp parallel for schedule(static) if (size >= parallel_from)
    for (std::ptrdiff_t k = 0; k < size; ++k)
      position[static_cast<std::size_t>(k)] +=
          length * normal(stream, static_cast<std::uint64_t>(k));
  }

 private:
  /// Box and Muller (1958), of two uniform draws.
  static double normal(std::uint64_t stream, std::uint64_t k) {
    const double radius = std::sqrt(-2 * std::log(1 - uniform_random(stream, 2 * k)));
    return radius * std::cos(2 * pi * uniform_random(stream, 2 * k + 1));
  }

  double viscosity_;
  std::uint64_t seed_;
};

}  // namespace

template <int D>
std::unique_ptr<VortexDiffusion<D>> vortex_diffusion(const VortexOptions& options,
                                                     SpaceSetup& setup) {
  switch (options.diffusion) {
    case Diffusion::sph:
      return std::make_unique<OperatorDiffusion<D>>(options, setup);
    case Diffusion::particle_strength_exchange:
      return std::make_unique<Exchange<D>>(options, setup);
    case Diffusion::core_spreading:
      return std::make_unique<CoreSpreading<D>>(options);
    case Diffusion::random_walk:
      return std::make_unique<RandomWalk<D>>(options);
    case Diffusion::none:
      break;
  }
  return std::make_unique<VortexDiffusion<D>>();
}

template std::unique_ptr<VortexDiffusion<3>> vortex_diffusion<3>(const VortexOptions&, SpaceSetup&);
template std::unique_ptr<VortexDiffusion<2>> vortex_diffusion<2>(const VortexOptions&, SpaceSetup&);

}  // namespace mote
