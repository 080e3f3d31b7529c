#include "mote/models/own_gravity.hpp"

#include "mote/models/few_bodies.hpp"
#include "mote/models/fixed_sum.hpp"

namespace mote {
namespace {

/// Bodies up to which summing pair by pair is about as fast, and exact.
constexpr std::size_t few = 6000;

}  // namespace

template <int D>
OwnGravity<D>::OwnGravity(const OwnGravityOptions& options)
    : options_(options),
      has_pairs_of_points_(options.core == "point" && options.method != "multipole"),
      direct_({SumMethod::direct, options.tolerance}, options.core),
      multipole_({SumMethod::multipole, options.tolerance}, options.core) {}

template <int D>
bool OwnGravity<D>::sums_pair_by_pair(std::size_t bodies) const {
  return options_.method == "direct" || (options_.method == "automatic" && bodies <= few);
}

template <int D>
Gravity<D>& OwnGravity<D>::sum_for(const Sources<D>& bodies) {
  return sums_pair_by_pair(bodies.strength.size()) ? direct_ : multipole_;
}

template <int D>
void OwnGravity<D>::accelerate(const Sources<D>& bodies, std::span<double> acceleration) {
  if (has_pairs_of_points_ && bodies.strength.size() <= few_bodies::most)
    return few_bodies::accelerate<D>(options_.gravitational_constant, bodies.strength,
                                     bodies.position, acceleration);
  sum_for(bodies).at_sources(bodies, {{}, acceleration});
  for (double& component : acceleration) component *= -options_.gravitational_constant;
}

template <int D>
void OwnGravity<D>::find_potential(const Sources<D>& bodies, std::span<double> potential) {
  sum_for(bodies).at_sources(bodies, {potential, {}});
  for (double& value : potential) value *= options_.gravitational_constant;
}

template <int D>
double OwnGravity<D>::energy(const Sources<D>& bodies) {
  potential_.resize(bodies.strength.size());
  find_potential(bodies, potential_);
  return 0.5 * fixed_sum(static_cast<Index>(potential_.size()), 0.0, [&](Index i) {
           const auto k = static_cast<std::size_t>(i);
           return bodies.strength[k] * potential_[k];
         });
}

template class OwnGravity<2>;
template class OwnGravity<3>;

}  // namespace mote
