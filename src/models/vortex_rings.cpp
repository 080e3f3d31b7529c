#include "mote/models/vortex_rings.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

using std::numbers::pi;

/// A place in the plane across the core: outwards from the ring's axis, and along it. What stands
/// there has the same area everywhere, and this part of the ring's circulation.
struct CorePlace {
  double out = 0, along = 0, share = 0;
};

/// Layer n has 8 n places at the radius 2 n b, in the ring of area 8 n pi b^2 from (2 n - 1) b to
/// (2 n + 1) b.
std::vector<CorePlace> layers_within(double radius, double spacing) {
  const double b = spacing / std::sqrt(pi);
  std::vector<CorePlace> places{{}};
  for (int n = 1; 2 * n * b <= radius; ++n)
    for (int k = 0; k < 8 * n; ++k) {
      const double angle = 2 * pi * (k + 0.5) / (8 * n);
      places.push_back({2 * n * b * std::cos(angle), 2 * n * b * std::sin(angle)});
    }
  return places;
}

/// Gives the places shares like exp(-(s/core)^2) and returns the mean of s^2 that comes out.
double mean_square(std::vector<CorePlace>& places, double core) {
  double sum = 0, squares = 0;
  for (CorePlace& place : places) {
    const double square = place.out * place.out + place.along * place.along;
    place.share = std::exp(-square / (core * core));
    sum += place.share;
    squares += place.share * square;
  }
  for (CorePlace& place : places) place.share /= sum;
  return squares / sum;
}

/// The mean of s^2 of a Gauss function is core^2. That of a few layers that end somewhere is less,
/// so the function is made wider until it is not.
std::vector<CorePlace> core_places(double core, const RingResolution& resolution) {
  const double end = core * std::sqrt(-std::log(std::max(resolution.threshold, 1e-12)));
  std::vector<CorePlace> places = layers_within(end, resolution.spacing);
  double width = core;
  for (int k = 0; k < 30 && places.size() > 1; ++k)
    width *= std::sqrt(core * core / mean_square(places, width));
  mean_square(places, width);
  return places;
}

void check(const VortexRing& ring, const RingResolution& resolution, const std::string& key) {
  for (const auto* triple : {&ring.centre, &ring.normal})
    if (triple->size() != 3)
      throw InputError(key + (triple == &ring.centre ? ".centre" : ".normal"),
                       fmt::format("three numbers are needed, and there are {}", triple->size()));
  if (Vec<3>::Map(ring.normal.data()).norm() == 0)
    throw InputError(key + ".normal", "'normal' has no direction");
  if (ring.core >= ring.radius)
    throw InputError(key + ".core",
                     fmt::format("the core of a ring is thinner than its radius, {:.6g}, and this "
                                 "is {:.6g}",
                                 ring.radius, ring.core));
  const double least = std::sqrt(2.0) * resolution.blob_size;
  if (ring.core <= least)
    throw InputError(key + ".core",
                     fmt::format("the blobs alone are as thick as {:.6g}, and the core must be "
                                 "thicker, here {:.6g}: a smaller 'spacing' or 'core.size' helps",
                                 least, ring.core));
}

/// Two directions across `normal`, by a fixed rule.
std::array<Vec<3>, 2> directions_across(const Vec<3>& normal) {
  int smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  const Vec<3> first = normal.cross(Vec<3>::Unit(smallest)).normalized();
  return {first, normal.cross(first)};
}

}  // namespace

VortexList<3> ring_particles(const VortexRing& ring, const RingResolution& resolution,
                             const std::string& key) {
  check(ring, resolution, key);
  const double core = std::sqrt(ring.core * ring.core - 2 * std::pow(resolution.blob_size, 2));
  const std::vector<CorePlace> places = core_places(core, resolution);
  if (std::ranges::any_of(places, [&](const CorePlace& p) { return p.out <= -ring.radius; }))
    throw InputError(key + ".core",
                     "the core reaches the ring's axis: a higher 'threshold' ends "
                     "it before");
  const Vec<3> centre = Vec<3>::Map(ring.centre.data());
  const Vec<3> normal = Vec<3>::Map(ring.normal.data()).normalized();
  const auto across = directions_across(normal);
  const auto sectors =
      std::max(8, static_cast<int>(std::lround(2 * pi * ring.radius / resolution.spacing)));
  VortexList<3> particles;
  for (int sector = 0; sector < sectors; ++sector) {
    const double angle = 2 * pi * sector / sectors;
    const Vec<3> out = std::cos(angle) * across[0] + std::sin(angle) * across[1];
    const Vec<3> round = normal.cross(out);
    for (const CorePlace& place : places) {
      const double length = 2 * pi * (ring.radius + place.out) / sectors;
      const Vec<3> x = centre + (ring.radius + place.out) * out + place.along * normal;
      const Vec<3> strength = place.share * ring.circulation * length * round;
      particles.add({x.data(), 3}, {strength.data(), 3});
      particles.volume.push_back(resolution.spacing * resolution.spacing * length);
    }
  }
  return particles;
}

}  // namespace mote
