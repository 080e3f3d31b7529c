#include "mote/app/neighbourhood.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace mote {
namespace {

/// Particles on the x axis at these places.
Cloud cloud_at(int dimension, const std::vector<double>& x) {
  Cloud cloud(dimension, static_cast<Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) cloud.position()[i * dimension] = x[i];
  return cloud;
}

TEST(Neighbourhood, OnALineIsTheNextInNumber) {
  const Cloud cloud = cloud_at(1, {0.5, 1.5, 2.5, 3.5});
  EXPECT_EQ(neighbourhood(cloud, {1, 2}), "0 at 0.5, 1 at 1.5, 2 at 2.5, 3 at 3.5");
  EXPECT_EQ(neighbourhood(cloud, {0}), "0 at 0.5, 1 at 1.5");
}

TEST(Neighbourhood, InSpaceIsTheNearestByTheirIds) {
  Cloud cloud = cloud_at(2, {9, 1, 8, 2, 3, 4, 5});
  for (int i = 0; double& id : cloud.add("id", FieldKind::scalar, "")) id = 10 * ++i;
  EXPECT_EQ(neighbourhood(cloud, {1}),
            "20 at (1, 0), 40 at (2, 0), 50 at (3, 0), 60 at (4, 0), 70 at (5, 0), 30 at (8, 0)");
}

TEST(Neighbourhood, OfAParticleThatIsNowhereIsStillTold) {
  const Cloud cloud = cloud_at(3, {NAN, 1, 2});
  EXPECT_THAT(neighbourhood(cloud, {0}), testing::StartsWith("0 at (nan, 0, 0), 1 at (1, 0, 0)"));
}

TEST(Neighbourhood, OfNoParticleIsEmpty) { EXPECT_EQ(neighbourhood(cloud_at(2, {1}), {}), ""); }

}  // namespace
}  // namespace mote
