#pragma once

#include <span>
#include <vector>

#include "mote/models/chosen_sum.hpp"
#include "mote/sums/gravity.hpp"

namespace mote {

/// What bodies do to each other by gravity. Nothing here depends on what it was asked before, or on
/// the number of threads.
template <int D>
class OwnGravity {
 public:
  OwnGravity(double gravitational_constant, const SumChoice& choice);

  /// -G grad phi at every body, D numbers each.
  void accelerate(const Sources<D>& bodies, std::span<double> acceleration);
  /// G phi at every body, of all the others.
  void find_potential(const Sources<D>& bodies, std::span<double> potential);
  /// G/2 sum of m phi: of every pair once.
  double energy(const Sources<D>& bodies);
  /// Whether so many bodies are summed pair by pair.
  bool sums_pair_by_pair(std::size_t bodies) const { return sums_.is_direct(bodies); }

 private:
  Gravity<D>& sum_for(const Sources<D>& bodies) { return sums_.of(bodies.strength.size()); }

  double gravitational_constant_;
  bool are_points_;
  ChosenSum<Gravity<D>> sums_;
  std::vector<double> potential_;  ///< work
};

extern template class OwnGravity<2>;
extern template class OwnGravity<3>;

}  // namespace mote
