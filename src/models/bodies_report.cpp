#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mote/models/bodies.hpp"
#include "mote/models/fixed_sum.hpp"
#include "mote/models/lagrangian_radii.hpp"

namespace mote {
namespace {

/// Bodies up to which the distances of all pairs cost next to nothing.
constexpr Index few = 100;

/// What a place and a velocity turn by: x cross v. One number in the plane.
Triple turn_of(const Vec<2>& x, const Vec<2>& v) { return {x[0] * v[1] - x[1] * v[0]}; }
Triple turn_of(const Vec<3>& x, const Vec<3>& v) {
  return {x[1] * v[2] - x[2] * v[1], x[2] * v[0] - x[0] * v[2], x[0] * v[1] - x[1] * v[0]};
}

}  // namespace

/// Mean over the mass.
template <int D>
Vec<D> Bodies<D>::weighted_mean(std::span<const double> vectors) const {
  const double mass =
      fixed_sum(cloud_.count(), 0.0, [&](Index i) { return mass_[static_cast<std::size_t>(i)]; });
  const Vec<D> sum = fixed_sum(cloud_.count(), Vec<D>(Vec<D>::Zero()), [&](Index i) -> Vec<D> {
    return mass_[static_cast<std::size_t>(i)] * at(vectors, i);
  });
  return sum / mass;
}

template <int D>
std::vector<Conserved> Bodies<D>::conserved() const {
  const auto sum = [&](auto term) {
    return fixed_sum(cloud_.count(), 0.0, [&](Index i) {
      return mass_[static_cast<std::size_t>(i)] * term(at(position_, i), at(velocity_, i));
    });
  };
  using V = const Vec<D>&;
  const double kinetic = sum([](V, V v) { return 0.5 * v.squaredNorm(); });
  const double potential = gravity_->energy(sources());
  std::vector<Conserved> quantities{{"energy", kinetic + potential, kinetic + std::abs(potential)}};
  const double momenta = sum([](V, V v) { return v.norm(); });
  for (int d = 0; d < D; ++d)
    quantities.push_back(
        {fmt::format("momentum_{}", axis_names[d]), sum([d](V, V v) { return v[d]; }), momenta});
  const double turns = sum([](V x, V v) { return x.norm() * v.norm(); });
  for (std::size_t d = 0; d < (D == 2 ? 1 : 3); ++d)
    quantities.push_back(
        {D == 2 ? "angular_momentum" : fmt::format("angular_momentum_{}", axis_names[d]),
         sum([d](V x, V v) { return turn_of(x, v)[d]; }), turns});
  return quantities;
}

/// Twice the kinetic energy over the virial of Clausius, -sum of m x a, both about the centre of
/// mass: 1 on average in time for what stays together, in 2D as in 3D, softened or not.
template <int D>
double Bodies<D>::virial_ratio() const {
  form_accelerations();
  const Vec<D> centre = weighted_mean(position_), drift = weighted_mean(velocity_);
  const auto sum = [&](auto term) {
    return fixed_sum(cloud_.count(), 0.0,
                     [&](Index i) { return mass_[static_cast<std::size_t>(i)] * term(i); });
  };
  const double motion = sum([&](Index i) { return (at(velocity_, i) - drift).squaredNorm(); });
  const double virial =
      -sum([&](Index i) { return (at(position_, i) - centre).dot(at(acceleration_, i)); });
  return motion / virial;
}

template <int D>
double Bodies<D>::least_separation() const {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < cloud_.count(); ++i)
    for (Index j = 0; j < i; ++j)
      least = std::min(least, (at(position_, i) - at(position_, j)).norm());
  return least;
}

template <int D>
std::int64_t Bodies<D>::collisions() const {
  return std::llround(std::accumulate(met_.begin(), met_.end(), 0.0) / 2);
}

template <int D>
std::string Bodies<D>::collisions_in_words() const {
  const auto words = [&](const Collision& collision) {
    return fmt::format("{} and {} at t = {:.9g} with the relative speed {:.6g}",
                       options_.name_of(collision.first), options_.name_of(collision.second),
                       collision.time, collision.speed);
  };
  std::vector<std::string> told;
  for (const Collision& collision : first_collisions_) told.push_back(words(collision));
  const std::int64_t count = collisions();
  return fmt::format("{} collision{}{}{}", count, count == 1 ? "" : "s",
                     told.empty()                                     ? ""
                     : count > static_cast<std::int64_t>(told.size()) ? ", among them: "
                                                                      : ": ",
                     fmt::join(told, ", "));
}

template <int D>
std::vector<std::string> Bodies<D>::warnings() const {
  if (collisions() == 0) return {};
  return {collisions_in_words() +
          ". The bodies went through each other: nothing merges or bounces"};
}

template <int D>
PairWork Bodies<D>::pair_work() const {
  PairWork work{.evaluations = evaluations_ + (series_ ? series_->expansions() : 0)};
  if (!gravity_->sums_pair_by_pair(mass_.size())) return work;
  const std::int64_t others = cloud_.count() - 1;
  work.pairs = work.evaluations * cloud_.count() * others;
  work.mean_neighbours = static_cast<double>(others);
  return work;
}

template <int D>
std::vector<Reading> Bodies<D>::readings() const {
  if (cloud_.count() < 2) return {};
  const double kinetic =
      0.5 * fixed_sum(cloud_.count(), 0.0, [&](Index i) {
        return mass_[static_cast<std::size_t>(i)] * at(velocity_, i).squaredNorm();
      });
  std::vector<Reading> readings{{"kinetic_energy", kinetic}};
  if (options_.gravitational_constant > 0) readings.push_back({"virial_ratio", virial_ratio()});
  if (collisions_.exist()) readings.push_back({"collisions", static_cast<double>(collisions())});
  if (cloud_.count() == 2) {
    readings.push_back({"separation", (at(position_, 1) - at(position_, 0)).norm()});
    return readings;
  }
  if (cloud_.count() <= few) readings.push_back({"least_separation", least_separation()});
  const Vec<D> centre = weighted_mean(position_);
  std::vector<double> distance;
  for (Index i = 0; i < cloud_.count(); ++i) distance.push_back((at(position_, i) - centre).norm());
  const auto radii = lagrangian_radii(distance, mass_, {0.1, 0.5, 0.9});
  readings.push_back({"radius_10_percent", radii[0]});
  readings.push_back({"half_mass_radius", radii[1]});
  readings.push_back({"radius_90_percent", radii[2]});
  return readings;
}

template <int D>
std::vector<std::string> Bodies<D>::remarks() const {
  const bool direct = gravity_->sums_pair_by_pair(mass_.size());
  const std::string sums =
      direct ? "pair by pair"
             : fmt::format("by the fast multipole method to {:.3g}", options_.tolerance);
  const std::string form =
      options_.core == "point"
          ? "points"
          : fmt::format("spread by '{}' of size {:.6g}", options_.core, options_.core_size);
  std::vector<std::string> remarks{
      fmt::format("{} bodies, {}, under gravity that was summed {}.", cloud_.count(), form, sums)};
  if (start_.lower != start_.upper)
    remarks.emplace_back(
        "Space has no bounds: the domain only says where the bodies are expected.");
  if (collisions_.exist() && collisions() == 0)
    remarks.emplace_back(
        "No bodies with a radius collided, by the cubic paths between the ends of steps.");
  return remarks;
}

template <int D>
Parameters Bodies<D>::parameters() const {
  Parameters parameters{{"gravitational_constant", options_.gravitational_constant},
                        {"bodies", static_cast<double>(cloud_.count())},
                        {"core_size", options_.core_size},
                        {"single_masses", static_cast<double>(options_.masses.size())},
                        {"clusters", static_cast<double>(options_.clusters.size())}};
  for (std::size_t k = 0; k < options_.clusters.size(); ++k) {
    const Cluster& cluster = options_.clusters[k];
    parameters[fmt::format("is_ball_{}", k)] = cluster.type == "uniform_ball" ? 1 : 0;
    parameters[fmt::format("mass_{}", k)] = cluster.mass;
    parameters[fmt::format("radius_{}", k)] = cluster.radius;
    for (std::size_t d = 0; d < D; ++d) {
      const auto component = [d](const std::vector<double>& numbers) {
        return numbers.empty() ? 0 : numbers[d];
      };
      parameters[fmt::format("{}_{}", axis_names[d], k)] = component(cluster.centre);
      parameters[fmt::format("velocity_{}_{}", axis_names[d], k)] = component(cluster.velocity);
    }
  }
  return parameters;
}

template class Bodies<2>;
template class Bodies<3>;

}  // namespace mote
