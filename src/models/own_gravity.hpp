#pragma once

#include <span>
#include <string>
#include <vector>

#include "mote/sums/gravity.hpp"

namespace mote {

struct OwnGravityOptions {
  double gravitational_constant = 1;
  std::string method = "automatic";  ///< or a name of `sum_methods`
  double tolerance = 1e-8;           ///< of multipole
  std::string core = "point";
};

/// What bodies do to each other by gravity. Nothing here depends on what it was asked before, or on
/// the number of threads.
template <int D>
class OwnGravity {
 public:
  explicit OwnGravity(const OwnGravityOptions& options);

  /// -G grad phi at every body, D numbers each.
  void accelerate(const Sources<D>& bodies, std::span<double> acceleration);
  /// G phi at every body, of all the others.
  void find_potential(const Sources<D>& bodies, std::span<double> potential);
  /// G/2 sum of m phi: of every pair once.
  double energy(const Sources<D>& bodies);
  /// Whether so many bodies are summed pair by pair.
  bool sums_pair_by_pair(std::size_t bodies) const;

 private:
  Gravity<D>& sum_for(const Sources<D>& bodies);

  OwnGravityOptions options_;
  bool has_pairs_of_points_;  ///< unless there are too many
  Gravity<D> direct_, multipole_;
  std::vector<double> potential_;  ///< work
};

extern template class OwnGravity<2>;
extern template class OwnGravity<3>;

}  // namespace mote
