#include "mote/xivas/particle_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

using Numbers = std::vector<double>;

TEST(LinearFit, IsExactForLinearFields) {
  const Numbers places{0, 0, 2, 0, 0, 3, -1, 1};
  Numbers vectors;
  for (std::size_t k = 0; k < places.size(); k += 2) {
    vectors.push_back(1 + 2 * places[k] - places[k + 1]);
    vectors.push_back(3 * places[k]);
  }
  const LinearFit<2> fit(places, vectors);
  EXPECT_LT((fit.at({5, -7}) - Vec<2>(18, 15)).norm(), 1e-13);
}

TEST(LinearFit, IsConstantAcrossPlacesOnALine) {
  const LinearFit<2> along_x({{0, 1, 1, 1, 3, 1}}, {{0, 5, 2, 5, 6, 5}});
  EXPECT_LT((along_x.at({2, 1}) - Vec<2>(4, 5)).norm(), 1e-14);
  EXPECT_LT((along_x.at({2, 9}) - Vec<2>(4, 5)).norm(), 1e-14);
  const LinearFit<3> one({{1, 2, 3}}, {{4, 5, 6}});
  EXPECT_EQ(one.at({7, 8, 9}), Vec<3>(4, 5, 6));
}

/// A lattice in the unit square, all at one speed.
MovingParticles lattice(int count, double speed) {
  MovingParticles particles;
  for (int i = 0; i < count * count; ++i) {
    particles.position.insert(particles.position.end(),
                              {(i % count + 0.5) / count, (i / count + 0.5) / count});
    particles.velocity.insert(particles.velocity.end(), {speed, 0});
    particles.acceleration.insert(particles.acceleration.end(), {0, 1});
  }
  return particles;
}

/// The mesh has one cell of its lattice, two simplices, for four particles and the room about them.
TEST(ParticleFields, HaveFewerCellsThanParticlesHoweverFarTheyGo) {
  for (const double step : {1e-3, 1.0, 1e3})
    for (const double speed : {0.0, 1.0}) {
      const ParticleFields<2> fields(lattice(20, speed), {}, step);
      EXPECT_GT(fields.mesh().cell_count(), 150);
      EXPECT_LT(fields.mesh().cell_count(), 260);
    }
}

TEST(ParticleFields, LetParticlesThatLeaveTheMeshGoOn) {
  const auto motions = ParticleFields<2>(lattice(8, 3), {}, 100).mean_motions();
  ASSERT_EQ(motions.size(), 64);
  for (const auto& motion : motions) {
    EXPECT_LT((motion.velocity - Vec<2>(3, 0)).norm(), 1e-14);
    EXPECT_LT((motion.acceleration - Vec<2>(0, 1)).norm(), 1e-14);
  }
}

/// Two halves of a periodic box that shear along their boundary: with images, particles at one side
/// of the box are in the same field as those at the other.
TEST(ParticleFields, AreTheSameOnBothSidesOfAPeriodicBox) {
  const auto unlikeness = [](double period) {
    MovingParticles particles = lattice(16, 0);
    for (std::size_t k = 0; k < particles.position.size(); k += 2)
      particles.velocity[k] = std::sin(2 * std::numbers::pi * (particles.position[k] - 0.1));
    const auto motions = ParticleFields<2>(particles, {period, period, 0}, 0.05).mean_motions();
    double worst = 0;
    for (std::size_t row = 0; row < 16; ++row) {
      const double first = particles.velocity[32 * row], last = particles.velocity[32 * row + 30];
      const double gradient = (first - last) * 16;
      const double bent_first = motions[16 * row].velocity[0] / first - 1;
      const double expected = std::expm1(gradient * 0.05) / (gradient * 0.05) - 1;
      worst = std::max(worst, std::abs(bent_first - expected) / std::abs(expected));
    }
    return worst;
  };
  EXPECT_LT(unlikeness(1), 0.2);
  EXPECT_GT(unlikeness(0), 0.4);
}

TEST(ParticleFields, RefuseWhatIsNotFinite) {
  MovingParticles particles = lattice(4, 1);
  particles.position[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ParticleFields<2>(particles, {}, 1), NumericalFailure);
}

}  // namespace
}  // namespace mote
