#include "mote/models/bodies_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mote/models/bodies.hpp"
#include "mote/models/chosen_sum.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

void describe_mass(Description& d, PointMass& body) {
  d.number(
      {"mass", "of the body; 0: a test particle, which feels the others and does not pull", true},
      body.mass, not_negative);
  d.numbers({"position", "one number a dimension", true}, body.position);
  d.numbers({"velocity", "one number a dimension; default: at rest"}, body.velocity);
  d.text({"name", "in reports; default: its number"}, body.name);
  d.number({"radius",
            "of a ball; two of these collide where they touch: that is reported, and they go on"},
           body.radius, not_negative);
}

void check_vector(const std::string& key, const std::vector<double>& numbers, int dimension) {
  if (numbers.size() == static_cast<std::size_t>(dimension)) return;
  throw InputError("model." + key,
                   fmt::format("'{}' needs {} numbers, one a dimension, and has {}",
                               key.substr(key.rfind('.') + 1), dimension, numbers.size()));
}

void check_optional_vector(const std::string& key, const std::vector<double>& numbers,
                           int dimension) {
  if (!numbers.empty()) check_vector(key, numbers, dimension);
}

}  // namespace

void BodiesOptions::describe(Description& d) {
  d.number({"gravitational_constant", "G; in 2D accelerations are G m/r, in 3D G m/r^2"},
           gravitational_constant, not_negative);
  d.section({"sum", "how the sums over all pairs are formed"}, [&] {
    d.choice({"method", "which way"}, sum, sum_choices("bodies"));
    d.number({"tolerance", "of the multipole method: error over the largest acceleration"},
             tolerance, {1e-13, 1e-3});
  });
  d.section({"softening", "how the mass of a body is spread"}, [&] {
    d.variant(
        {"name", "form of the spread mass"}, core, core_choices("none: point masses"),
        [&](const std::string& name) {
          if (name != "point")
            d.number({"size", "its radius, the same for all bodies", true}, core_size, positive);
        });
  });
  describe_list(d, {"masses", "bodies that are given by themselves"}, masses,
                [&](PointMass& body) { describe_mass(d, body); });
  describe_list(d, {"clusters", "of bodies that are drawn at random"}, clusters,
                [&](Cluster& cluster) { describe_cluster(d, cluster); });
}

void BodiesOptions::check(int dimension) const {
  if (masses.empty() && clusters.empty())
    throw InputError("model", "there is no body: give 'masses' or 'clusters'");
  check_masses(dimension);
  check_clusters(dimension);
}

void BodiesOptions::check_masses(int dimension) const {
  std::set<std::string> names;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    check_vector(fmt::format("masses.{}.position", k), masses[k].position, dimension);
    check_optional_vector(fmt::format("masses.{}.velocity", k), masses[k].velocity, dimension);
    if (!masses[k].name.empty() && !names.insert(masses[k].name).second)
      throw InputError(fmt::format("model.masses.{}.name", k),
                       fmt::format("there are two masses with the name '{}'", masses[k].name));
  }
  if (clusters.empty() && std::ranges::none_of(masses, [](auto& body) { return body.mass > 0; }))
    throw InputError("model.masses", "no body has a mass above 0");
}

void BodiesOptions::check_clusters(int dimension) const {
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const std::string key = fmt::format("clusters.{}.", k);
    check_optional_vector(key + "centre", clusters[k].centre, dimension);
    check_optional_vector(key + "velocity", clusters[k].velocity, dimension);
    if (clusters[k].type == "plummer" && dimension != 3)
      throw InputError("model." + key + "type",
                       "the sphere 'plummer' has 3 dimensions, this scenario has 2");
  }
}

std::size_t BodiesOptions::cluster_of(std::size_t body) const {
  std::size_t end = masses.size(), k = 0;
  while (body >= (end += static_cast<std::size_t>(clusters[k].count))) ++k;
  return k;
}

std::string BodiesOptions::key_of(std::size_t body) const {
  if (body < masses.size()) return fmt::format("model.masses.{}.position", body);
  return fmt::format("model.clusters.{}", cluster_of(body));
}

std::string BodiesOptions::name_of(std::size_t body) const {
  if (body >= masses.size()) return fmt::format("a body of cluster {}", cluster_of(body) + 1);
  return masses[body].name.empty() ? fmt::format("mass {}", body + 1) : masses[body].name;
}

std::optional<double> BodiesRecipe::own_particles() const {
  auto count = static_cast<double>(options.masses.size());
  for (const Cluster& cluster : options.clusters) count += static_cast<double>(cluster.count);
  return count;
}

std::vector<std::string> BodiesRecipe::conserved_names(int dimension) const {
  std::vector<std::string> names{"energy"};
  for (int d = 0; d < dimension; ++d) names.push_back(fmt::format("momentum_{}", axis_names[d]));
  if (dimension == 2) names.emplace_back("angular_momentum");
  for (int d = 0; d < dimension && dimension == 3; ++d)
    names.push_back(fmt::format("angular_momentum_{}", axis_names[d]));
  return names;
}

std::unique_ptr<Model> BodiesRecipe::make(SpaceSetup setup) const {
  options.check(setup.dimension);
  if (setup.dimension == 2) return std::make_unique<Bodies<2>>(options, std::move(setup));
  return std::make_unique<Bodies<3>>(options, std::move(setup));
}

}  // namespace mote
