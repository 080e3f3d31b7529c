#include "mote/exact/kepler_pair.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace mote {
namespace {

using Real = long double;
using Vector = std::array<Real, 3>;

Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector difference(const std::array<std::array<double, 3>, 2>& of_bodies) {
  Vector result{};
  for (std::size_t d = 0; d < 3; ++d) result[d] = Real{of_bodies[1][d]} - of_bodies[0][d];
  return result;
}

std::array<double, 3> unit(const Vector& vector) {
  const Real length = std::sqrt(dot(vector, vector));
  std::array<double, 3> result{};
  for (std::size_t d = 0; d < 3; ++d) result[d] = static_cast<double>(vector[d] / length);
  return result;
}

/// The orbit through x with the velocity v, in the plane of the two with x on its first axis. Twice
/// as many digits as needed: 1/a is the small difference of large numbers where e is near 1.
KeplerElements elements_of(Real parameter, const Vector& x, const Vector& v) {
  const Vector momentum = cross(x, v);
  const Real distance = std::sqrt(dot(x, x)), turn = std::sqrt(dot(momentum, momentum));
  const Real inverse_axis = 2 / distance - dot(v, v) / parameter;
  if (!(inverse_axis > 0))
    throw std::domain_error("needs two bodies that are bound to each other: these part for ever");
  if (turn == 0) throw std::domain_error("needs bodies on an ellipse: these fall on a line");
  const Real axis = 1 / inverse_axis, speed = std::sqrt(parameter / axis);
  const Real cosine = 1 - distance / axis, sine = dot(x, v) / (axis * speed);  // e times those of E
  const Real eccentricity = std::hypot(cosine, sine), anomaly = std::atan2(sine, cosine);
  const Real minor_over_major = turn / (axis * speed);  // sqrt(1 - e^2)
  const Real true_anomaly =
      std::atan2(minor_over_major * std::sin(anomaly), std::cos(anomaly) - eccentricity);
  return {.gravitational_parameter = static_cast<double>(parameter),
          .semi_major_axis = static_cast<double>(axis),
          .eccentricity = static_cast<double>(eccentricity),
          .direction = static_cast<double>(-true_anomaly),
          .time_of_pericentre = static_cast<double>(-(anomaly - sine) * axis / speed)};
}

}  // namespace

KeplerPair::KeplerPair(const TwoBodies& start) {
  const Vector x = difference(start.position), v = difference(start.velocity);
  const double mass = start.mass[0] + start.mass[1];
  elements_ = elements_of(Real{start.gravitational_constant} * mass, x, v);
  axes_ = {unit(x), unit(cross(cross(x, v), x))};
  share_ = {-start.mass[1] / mass, start.mass[0] / mass};
  const auto mean = [&](const std::array<Triple, 2>& of, std::size_t d) {
    return (start.mass[0] * of[0][d] + start.mass[1] * of[1][d]) / mass;
  };
  for (std::size_t d = 0; d < 3; ++d) {
    centre_[d] = mean(start.position, d);
    centre_velocity_[d] = mean(start.velocity, d);
  }
}

std::string KeplerPair::statement() const {
  return fmt::format(
      "kepler is exact for these two bodies: eccentricity {:.6g}, semi-major axis {:.6g}, period "
      "{:.6g}",
      eccentricity(), semi_major_axis(), period());
}

Table KeplerPair::at_places(std::span<const double> /*position*/, int /*dimension*/,
                            double /*time*/) const {
  throw std::logic_error("the motion of two bodies is known by body, not by place");
}

KeplerPair::Triple KeplerPair::in_space(const std::array<double, 2>& vector) const {
  Triple result{};
  for (std::size_t d = 0; d < 3; ++d) result[d] = vector[0] * axes_[0][d] + vector[1] * axes_[1][d];
  return result;
}

Table KeplerPair::of_particles(double time) const {
  const OrbitState state = KeplerOrbit(elements_).at(time);
  const Triple separation = in_space(state.position), velocity = in_space(state.velocity);
  Table table{{"position_x", {}}, {"position_y", {}}, {"position_z", {}},
              {"velocity_x", {}}, {"velocity_y", {}}, {"velocity_z", {}}};
  for (const double share : share_)
    for (std::size_t d = 0; d < 3; ++d) {
      table[d].values.push_back(centre_[d] + time * centre_velocity_[d] + share * separation[d]);
      table[d + 3].values.push_back(centre_velocity_[d] + share * velocity[d]);
    }
  return table;
}

}  // namespace mote
