#include "mote/models/clusters.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mote/particles/random.hpp"

namespace mote {
namespace {

/// Random numbers of one body, one after the other.
class Draws {
 public:
  Draws(std::int64_t seed, std::size_t body)
      : seed_(static_cast<std::uint64_t>(seed)), counter_(body * numbers_a_body) {}

  /// Uniform in [0, 1).
  double next() { return uniform_random(seed_, counter_++); }

 private:
  /// More than rejection, which accepts 3 of 7, ever takes.
  static constexpr std::uint64_t numbers_a_body = 1024;

  std::uint64_t seed_, counter_;
};

/// A unit vector, all directions alike.
template <int D>
Vec<D> direction(Draws& draws) {
  const double turn = 2 * std::numbers::pi * draws.next();
  if constexpr (D == 2) return {std::cos(turn), std::sin(turn)};
  if constexpr (D == 3) {
    const double height = 2 * draws.next() - 1, across = std::sqrt(1 - height * height);
    return {across * std::cos(turn), across * std::sin(turn), height};
  }
}

/// Speed over that of escape. With the distribution function f ~ (-E)^(7/2) it is distributed as
/// q^2 (1 - q^2)^(7/2), which is nowhere above 0.1.
double part_of_escape_speed(Draws& draws) {
  for (;;) {
    const double q = draws.next(), height = 0.1 * draws.next();
    if (height < q * q * std::pow(1 - q * q, 3.5)) return q;
  }
}

/// The potential -G M/sqrt(r^2 + a^2) holds the mass M (1 + (a/r)^2)^(-3/2) within r.
void add_plummer_body(const Cluster& cluster, double constant, Draws& draws, MassList<3>& bodies) {
  const double a = cluster.radius, held = plummer_mass_within(cluster.cut_off);
  const double within = held * (1 - draws.next());
  const double r = a / std::sqrt(std::pow(within, -2.0 / 3) - 1);
  const Vec<3> place = r * direction<3>(draws);
  const double escape = std::sqrt(2 * constant * (cluster.mass / held) / std::hypot(r, a));
  const double speed = escape * part_of_escape_speed(draws);
  bodies.add(cluster.mass / static_cast<double>(cluster.count), place, speed * direction<3>(draws));
}

template <int D>
void add_ball_body(const Cluster& cluster, Draws& draws, MassList<D>& bodies) {
  const double r = cluster.radius * std::pow(draws.next(), 1.0 / D);
  bodies.add(cluster.mass / static_cast<double>(cluster.count), r * direction<D>(draws),
             Vec<D>::Zero());
}

/// Gives vectors of D numbers this mean; no numbers mean 0.
template <int D>
void shift_mean(std::vector<double>& vectors, const std::vector<double>& mean) {
  const auto count = static_cast<double>(vectors.size() / D);
  Vec<D> shift = Vec<D>::Zero();
  for (std::size_t k = 0; k < vectors.size(); ++k)
    shift[static_cast<Eigen::Index>(k % D)] -= vectors[k] / count;
  for (std::size_t d = 0; d < mean.size(); ++d) shift[static_cast<Eigen::Index>(d)] += mean[d];
  for (std::size_t k = 0; k < vectors.size(); ++k)
    vectors[k] += shift[static_cast<Eigen::Index>(k % D)];
}

}  // namespace

template <int D>
void MassList<D>::add(double body_mass, const Vec<D>& place, const Vec<D>& speed) {
  mass.push_back(body_mass);
  position.insert(position.end(), place.begin(), place.end());
  velocity.insert(velocity.end(), speed.begin(), speed.end());
}

template <int D>
void MassList<D>::append(const MassList& others) {
  mass.insert(mass.end(), others.mass.begin(), others.mass.end());
  position.insert(position.end(), others.position.begin(), others.position.end());
  velocity.insert(velocity.end(), others.velocity.begin(), others.velocity.end());
}

void describe_cluster(Description& d, Cluster& cluster) {
  const Choices types{{"plummer", "a sphere in equilibrium, its density (1 + (r/a)^2)^(-5/2)"},
                      {"uniform_ball", "at rest; in the plane a disc"}};
  d.variant(
      {"type", "how its bodies lie and move", true}, cluster.type, types,
      [&](const std::string& type) {
        if (type == "plummer") {
          d.number({"scale_radius", "a", true}, cluster.radius, positive);
          d.number({"cut_off", "no body is further out, in scale radii"}, cluster.cut_off, {0.1});
        } else if (type == "uniform_ball") {
          d.number({"radius", "of the ball", true}, cluster.radius, positive);
        }
      });
  d.count({"count", "of bodies", true}, cluster.count, {1, 1e9});
  d.number({"mass", "of all its bodies together"}, cluster.mass, positive);
  d.count({"seed", "of the random numbers: another one is another cluster"}, cluster.seed,
          not_negative);
  d.numbers({"centre", "of mass, one number a dimension; default: the origin"}, cluster.centre);
  d.numbers({"velocity", "of the centre of mass; default: it is at rest"}, cluster.velocity);
}

double plummer_mass_within(double scale_radii) {
  return std::pow(1 + 1 / (scale_radii * scale_radii), -1.5);
}

template <int D>
MassList<D> sampled(const Cluster& cluster, double gravitational_constant) {
  MassList<D> bodies;
  for (std::size_t i = 0; i < static_cast<std::size_t>(cluster.count); ++i) {
    Draws draws(cluster.seed, i);
    if (cluster.type == "uniform_ball") {
      add_ball_body(cluster, draws, bodies);
      continue;
    }
    if constexpr (D == 2) throw std::invalid_argument("a Plummer sphere has three dimensions");
    if constexpr (D == 3) add_plummer_body(cluster, gravitational_constant, draws, bodies);
  }
  shift_mean<D>(bodies.position, cluster.centre);
  shift_mean<D>(bodies.velocity, cluster.velocity);
  return bodies;
}

template struct MassList<2>;
template struct MassList<3>;
template MassList<2> sampled<2>(const Cluster&, double);
template MassList<3> sampled<3>(const Cluster&, double);

}  // namespace mote
