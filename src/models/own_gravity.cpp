#include "mote/models/own_gravity.hpp"

#include "mote/models/few_bodies.hpp"
#include "mote/models/fixed_sum.hpp"

namespace mote {
namespace {

constexpr std::size_t few = 6000;

}  // namespace

template <int D>
OwnGravity<D>::OwnGravity(double gravitational_constant, const SumChoice& choice)
    : gravitational_constant_(gravitational_constant),
      are_points_(choice.core == "point"),
      sums_(choice, few) {}

template <int D>
void OwnGravity<D>::accelerate(const Sources<D>& bodies, std::span<double> acceleration) {
  const std::size_t count = bodies.strength.size();
  if (are_points_ && count <= few_bodies::most && sums_.is_direct(count))
    return few_bodies::accelerate<D>(gravitational_constant_, bodies.strength, bodies.position,
                                     acceleration);
  sum_for(bodies).at_sources(bodies, {{}, acceleration});
  for (double& component : acceleration) component *= -gravitational_constant_;
}

template <int D>
void OwnGravity<D>::find_potential(const Sources<D>& bodies, std::span<double> potential) {
  sum_for(bodies).at_sources(bodies, {potential, {}});
  for (double& value : potential) value *= gravitational_constant_;
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
