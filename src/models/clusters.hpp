#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mote/options/description.hpp"
#include "mote/particles/vector.hpp"

namespace mote {

/// Bodies as bare numbers: D for the place and for the velocity of each.
template <int D>
struct MassList {
  std::vector<double> mass, position, velocity;

  std::size_t count() const { return mass.size(); }
  void add(double body_mass, const Vec<D>& place, const Vec<D>& speed);
  void append(const MassList& others);
};

/// Bodies of equal mass that are drawn at random; see `describe_cluster` for the meaning.
struct Cluster {
  std::string type;
  std::int64_t count = 0;
  double mass = 1;    ///< of all bodies together
  double radius = 1;  ///< scale radius of a Plummer sphere, or that of the ball
  double cut_off = 10;
  std::int64_t seed = 0;
  std::vector<double> centre, velocity;  ///< none: 0
};

/// Says what an entry of `clusters` holds.
void describe_cluster(Description& description, Cluster& cluster);

/// The bodies of a cluster, with its centre of mass and mean velocity exact but for rounding. Body
/// i depends on the seed and on i alone. `plummer` has the isotropic velocities of its distribution
/// function under this gravitational constant (Aarseth, Henon & Wielen 1974, appendix): what is cut
/// off beyond the cut-off radius is part of the sphere that holds the others, but not of the mass.
/// `uniform_ball` (in the plane a disc) is at rest. Throws std::invalid_argument for `plummer` in
/// the plane.
template <int D>
MassList<D> sampled(const Cluster& cluster, double gravitational_constant);

/// The part of a Plummer sphere's mass within so many scale radii: (c^2/(1 + c^2))^(3/2).
double plummer_mass_within(double scale_radii);

extern template struct MassList<2>;
extern template struct MassList<3>;
extern template MassList<2> sampled<2>(const Cluster&, double);
extern template MassList<3> sampled<3>(const Cluster&, double);

}  // namespace mote
