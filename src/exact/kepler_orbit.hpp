#pragma once

#include <array>

namespace mote {

/// The elements of an ellipse about a centre of attraction (or of one body about another).
struct KeplerElements {
  double gravitational_parameter = 1;  ///< G times the sum of the masses [length^3/time^2]
  double semi_major_axis = 1;
  double eccentricity = 0;  ///< at least 0, less than 1
  double direction = 0;     ///< angle of the pericentre from the x axis
  double time_of_pericentre = 0;
};

/// Where a body on its orbit is, relative to the centre of attraction.
struct OrbitState {
  std::array<double, 2> position, velocity, acceleration;
};

/// The eccentric anomaly E of Kepler's equation E - e sin E = M for a mean anomaly M from -pi to pi
/// and 0 <= e < 1, to the precision of `long double`, also where both are small and e is near 1.
long double eccentric_anomaly(long double mean_anomaly, long double eccentricity);

/// The exact motion under the attraction of a point mass, in the plane of the orbit, counter-
/// clockwise:
///   x = a (cos E - e),   y = a sqrt(1 - e^2) sin E,   E - e sin E = n (t - t_p),   n^2 a^3 = mu,
/// with x towards the pericentre (e.g. Murray & Dermott 1999, 2.4). The mean anomaly has the
/// precision of `long double`, so 1e-19 of all the angle gone round since the time of pericentre;
/// for that anomaly, states are right to a unit or two in their last place.
class KeplerOrbit {
 public:
  /// Throws std::domain_error unless the elements are those of an ellipse.
  explicit KeplerOrbit(const KeplerElements& elements);

  OrbitState at(double time) const;
  double period() const;

 private:
  KeplerElements elements_;
  long double mean_motion_;
};

}  // namespace mote
