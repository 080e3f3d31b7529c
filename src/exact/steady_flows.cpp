#include "mote/exact/steady_flows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/xivas/matrix_exponentials.hpp"

namespace mote {
namespace {

/// position_x, ..., velocity_x, ...
Table particle_table(int dimension) {
  Table table;
  for (const char* quantity : {"position", "velocity"})
    for (int d = 0; d < dimension; ++d)
      table.push_back({fmt::format("{}_{}", quantity, std::string("xyz").substr(d, 1)), {}});
  return table;
}

}  // namespace

LinearFlow::LinearFlow(const LinearVelocity& velocity, std::vector<double> position)
    : velocity_(velocity), start_(std::move(position)) {}

std::string LinearFlow::statement() const {
  return "linear_flow is exact for material points in a steady velocity that is linear in space";
}

FlowState LinearFlow::state_at(const std::array<double, 3>& place) const {
  const Eigen::Vector3d velocity =
      velocity_.gradient * (Eigen::Vector3d::Map(place.data()) - velocity_.centre) +
      velocity_.at_centre;
  return {{velocity[0], velocity[1], velocity[2]}};
}

Table LinearFlow::at_places(std::span<const double> position, int dimension,
                            double /*time*/) const {
  return flow_table(position, dimension, WithPressure::no,
                    [this](const auto& place) { return state_at(place); });
}

Table LinearFlow::of_particles(double time) const {
  using Matrix = Eigen::Matrix<long double, 3, 3>;
  const Matrix q =
      matrix_exponentials<long double, 3>(velocity_.gradient.cast<long double>(), time).q;
  const auto dimension = static_cast<std::size_t>(velocity_.dimension);
  Table table = particle_table(velocity_.dimension);
  for (std::size_t first = 0; first < start_.size(); first += dimension) {
    std::array<double, 3> place{};
    std::copy_n(&start_[first], dimension, place.begin());
    const auto velocity = state_at(place).velocity;
    const Eigen::Matrix<long double, 3, 1> way =
        q * Eigen::Vector3d::Map(velocity.data()).cast<long double>();
    for (std::size_t d = 0; d < dimension; ++d)
      place[d] = static_cast<double>(place[d] + way[static_cast<Eigen::Index>(d)]);
    const auto at_end = state_at(place).velocity;
    for (std::size_t d = 0; d < dimension; ++d) {
      table[d].values.push_back(place[d]);
      table[dimension + d].values.push_back(at_end[d]);
    }
  }
  return table;
}

CircularFlow::CircularFlow(const std::array<double, 2>& centre, std::vector<CirclingPoint> points)
    : centre_(centre), points_(std::move(points)), by_radius_(points_) {
  std::ranges::sort(by_radius_, {}, &CirclingPoint::radius);
}

std::string CircularFlow::statement() const {
  return fmt::format(
      "circular_flow is exact for material points in a steady vortex about ({:.6g}, {:.6g})",
      centre_[0], centre_[1]);
}

double CircularFlow::angular_velocity(double radius) const {
  const auto next = std::ranges::lower_bound(by_radius_, radius, {}, &CirclingPoint::radius);
  if (next == by_radius_.begin()) return next->angular_velocity;
  const auto last = std::prev(next);
  if (next == by_radius_.end() || next->radius == last->radius) return last->angular_velocity;
  const double part = (radius - last->radius) / (next->radius - last->radius);
  return std::lerp(last->angular_velocity, next->angular_velocity, part);
}

Table CircularFlow::at_places(std::span<const double> position, int dimension,
                              double /*time*/) const {
  return flow_table(position, dimension, WithPressure::no, [this](const auto& place) -> FlowState {
    const double x = place[0] - centre_[0], y = place[1] - centre_[1];
    const double turning = angular_velocity(std::hypot(x, y));
    return {{-turning * y, turning * x}};
  });
}

Table CircularFlow::of_particles(double time) const {
  Table table = particle_table(2);
  for (const CirclingPoint& point : points_) {
    const double angle = point.angle + point.angular_velocity * time;
    const double x = point.radius * std::cos(angle), y = point.radius * std::sin(angle);
    const double row[] = {centre_[0] + x, centre_[1] + y, -point.angular_velocity * y,
                          point.angular_velocity * x};
    for (std::size_t c = 0; c < table.size(); ++c) table[c].values.push_back(row[c]);
  }
  return table;
}

}  // namespace mote
