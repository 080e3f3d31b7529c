#include "mote/sums/largest_values.hpp"

#include <gtest/gtest.h>

#include "mote/operators/cores/all.hpp"
#include "mote/sums/direct_sum.hpp"
#include "mote/sums/space_fields.hpp"
#include "sums/clouds.hpp"

namespace mote::test {
namespace {

using Numbers = std::vector<double>;

/// Masses in space, and places where they are felt.
struct Masses {
  Numbers positions, mass, targets;

  explicit Masses(Numbers places) : positions(std::move(places)) {
    mass = Draws(4).uniform(positions.size() / 3, 0, 1);
  }

  template <class Kernel>
  FarErrors at_least(const Kernel& kernel) const {
    PointTree<3> sources, others;
    sources.build(positions, 20);
    if (!targets.empty()) others.build(targets, 20);
    const PointTree<3>& tree = targets.empty() ? sources : others;
    NumberColumns strengths;
    strengths.take(mass, 1, 1, sources.order());
    PlacedPairs<Kernel> pairs{tree, {}, {{}, {strengths.column(0)}}, mass.size(), targets.empty()};
    for (std::size_t d = 0; d < 3; ++d) {
      pairs.targets[d] = tree.positions()[d].data();
      pairs.sources.position[d] = sources.positions()[d].data();
    }
    return LargestValues<Kernel>(kernel, pairs).at_least();
  }

  /// The largest potential and gradient of all targets, less `own` times its mass of the potential.
  template <class Kernel>
  FarErrors largest(const Kernel& kernel, double own) const {
    const Numbers& places = targets.empty() ? positions : targets;
    const std::size_t count = places.size() / 3;
    Numbers potential(count), gradient(3 * count);
    DirectSum<3> sum;
    sum.place(places, {positions, mass});
    sum.form(kernel);
    sum.give(0, 1, potential);
    sum.give(1, 3, gradient);
    FarErrors most{};
    for (std::size_t i = 0; i < count; ++i) {
      most[0] = std::max(most[0], std::abs(potential[i] + own * mass[i]));
      most[1] =
          std::max(most[1], std::hypot(gradient[3 * i], gradient[3 * i + 1], gradient[3 * i + 2]));
    }
    return most;
  }
};

using PointKernel = GravityKernel<PointShape<3>, GravityPart::both>;

TEST(LargestValues, AreThoseOfSomeTargets) {
  for (const PointCloud& cloud : clouds<3>(some_points)) {
    SCOPED_TRACE(cloud.name);
    const Masses masses(cloud.positions);
    const FarErrors found = masses.at_least(PointKernel{});
    const FarErrors largest = masses.largest(PointKernel{}, 0);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(found[i], largest[i] * (1 + 1e-12)) << i;
      EXPECT_GE(found[i], 0.3 * largest[i]) << i;
    }
    EXPECT_EQ(found[2], std::numeric_limits<double>::infinity());
  }
}

TEST(LargestValues, AreFoundAtOtherTargetsToo) {
  Masses masses(clouds<3>(some_points).front().positions);
  masses.targets = Draws(6).uniform(900, -2, 2);
  const FarErrors found = masses.at_least(PointKernel{}),
                  largest = masses.largest(PointKernel{}, 0);
  EXPECT_LE(found[0], largest[0] * (1 + 1e-12));
  EXPECT_LE(found[1], largest[1] * (1 + 1e-12));
  EXPECT_GE(found[0], 0.3 * largest[0]);
  EXPECT_GT(found[1], 0);
}

TEST(LargestValues, LeaveOutThePotentialOfABlobItself) {
  using Shape = BlobShape<3, GaussCore>;
  const double size = 1e-6;
  const GravityKernel<Shape, GravityPart::both> kernel{Shape::of_size(size)};
  const double own = at_distance(kernel.shape, 0).potential()[0];
  const Masses masses(clouds<3>(some_points).front().positions);
  const FarErrors found = masses.at_least(kernel);
  EXPECT_LE(found[0], masses.largest(kernel, own)[0] * (1 + 1e-9));
  EXPECT_GT(masses.largest(kernel, 0)[0], 10 * found[0]);  // what its own would make of it
}

}  // namespace
}  // namespace mote::test
