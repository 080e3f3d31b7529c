#pragma once

#include <array>
#include <string_view>

#include "mote/exact/flow_solution.hpp"
#include "mote/exact/kepler_orbit.hpp"

namespace mote {

/// Two point masses at the time 0; one of the masses may be 0.
struct TwoBodies {
  double gravitational_constant = 1;
  std::array<double, 2> mass{};
  std::array<std::array<double, 3>, 2> position{}, velocity{};
};

/// Their motion under nothing but their own gravity: on ellipses about their centre of mass, which
/// moves on evenly (Kepler's problem; Murray & Dermott 1999, 2.7). The relative orbit has the
/// gravitational parameter mu = G (m_1 + m_2) and, by the state x, v at the start,
///   1/a = 2/|x| - v^2/mu,   e cos E = 1 - |x|/a,   e sin E = x . v/sqrt(mu a).
class KeplerPair final : public FlowSolution {
 public:
  static constexpr std::string_view name = "kepler";
  static constexpr std::string_view summary = "two bodies on ellipses about their centre of mass";

  /// Throws std::domain_error, with what is wrong in words that follow the name, for bodies that
  /// are not bound to each other, or fall on a line.
  explicit KeplerPair(const TwoBodies& start);

  std::string statement() const override;
  /// Throws std::logic_error: the motion is known by body.
  Table at_places(std::span<const double> position, int dimension, double time) const override;
  bool knows_particles() const override { return true; }
  Table of_particles(double time) const override;

  double eccentricity() const { return elements_.eccentricity; }
  double semi_major_axis() const { return elements_.semi_major_axis; }
  double period() const { return KeplerOrbit(elements_).period(); }

 private:
  using Triple = std::array<double, 3>;

  /// A vector in the plane of the orbit as one in space.
  Triple in_space(const std::array<double, 2>& vector) const;

  KeplerElements elements_;              ///< in the plane, whose first axis is the separation at 0
  std::array<Triple, 2> axes_{};         ///< of that plane
  std::array<double, 2> share_{};        ///< of the separation that is each body's, with its sign
  Triple centre_{}, centre_velocity_{};  ///< of mass, at 0
};

}  // namespace mote
