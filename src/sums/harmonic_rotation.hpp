#pragma once

#include <array>

#include "mote/operators/differential/lanes.hpp"
#include "mote/sums/harmonic_tables.hpp"

namespace mote {

/// cos(m angle) and sin(m angle) for all orders m up to a degree.
class Phases {
 public:
  /// `cosine` and `sine` of the angle itself.
  void prepare(int degree, const Lanes& cosine, const Lanes& sine);
  const Lanes& cosine(int order) const { return cosine_[static_cast<std::size_t>(order)]; }
  const Lanes& sine(int order) const { return sine_[static_cast<std::size_t>(order)]; }

 private:
  std::array<Lanes, highest_degree + 1> cosine_, sine_;
};

/// Directions of eight displacements, and the turns of the axes by which each of them comes to lie
/// along +z: about z until its x is 0, then about x.
struct AxisTurn {
  const HarmonicTables& tables = harmonic_tables();
  Phases azimuth, polar;
  Lanes distance;

  /// One of length 0 has the direction of z. Components may be of any magnitude.
  void prepare(int degree, const std::array<Lanes, 3>& displacement);
};

/// Coefficients of one degree n (2n + 1 numbers) in the axes after the turn. Rotations about x are
/// done as rotations about z with x and z exchanged before and after, so all but phases is constant
/// (Dehnen 2014, A fast multipole method for stellar dynamics, section 3.3).
void turn_to_axis(int degree, const AxisTurn& turn, const Lanes* coefficients, Lanes* turned);
/// Adds `factor` times the coefficients in the axes before the turn.
void add_turned_from_axis(int degree, const AxisTurn& turn, const Lanes& factor,
                          const Lanes* turned, Lanes* sums);

}  // namespace mote
