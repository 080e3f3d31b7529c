#include <gtest/gtest.h>
#include <omp.h>

#include <string>

#include "long_sums.hpp"
#include "mote/particles/failure.hpp"
#include "mote/sums/biot_savart.hpp"
#include "mote/sums/gravity.hpp"
#include "support/agreement.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

constexpr SumSettings direct{.method = SumMethod::direct};
constexpr double tolerance = 1e-14;

std::vector<std::string> cores() {
  std::vector<std::string> names{"point"};
  for_each_type(VortexCores{}, [&]<class Core>() { names.emplace_back(Core::name); });
  return names;
}

/// Sources and targets in a unit box; counts leave packs, groups and blocks of them part filled.
template <int D>
struct Cloud {
  static constexpr std::size_t source_count = 533, target_count = 109;
  Draws draws{7};
  std::vector<double> position = draws.uniform(source_count * D, 0, 1);
  std::vector<double> mass = draws.uniform(source_count, 0.1, 1);
  std::vector<double> circulation = draws.uniform(source_count * (D == 2 ? 1 : 3), -1, 1);
  std::vector<double> targets = draws.uniform(target_count * D, -0.1, 1.1);

  Sources<D> masses() const { return {position, mass, 0.08}; }
  Sources<D> vortices() const { return {position, circulation, 0.08}; }
};

template <int D>
struct GravityNumbers {
  explicit GravityNumbers(std::size_t count) : potential(count), gradient(count * D) {}
  GravityField field() { return {potential, gradient}; }
  std::vector<double> potential, gradient;
};

template <int D>
struct VelocityNumbers {
  explicit VelocityNumbers(std::size_t count) : velocity(count * D), gradient(count * D * D) {}
  VelocityField field() { return {velocity, gradient}; }
  std::vector<double> velocity, gradient;
};

template <class Dimension>
struct DirectSums : testing::Test {};
using TwoAndThree = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(DirectSums, TwoAndThree);

TYPED_TEST(DirectSums, GravityIsTheSumOverAllPairs) {
  constexpr int D = TypeParam::value;
  const Cloud<D> cloud;
  for (const auto& core : cores()) {
    SCOPED_TRACE(core);
    Gravity<D> gravity(direct, core);
    GravityNumbers<D> found(cloud.target_count), own(cloud.source_count);
    gravity.at(cloud.targets, cloud.masses(), found.field());
    gravity.at_sources(cloud.masses(), own.field());
    const auto expected = long_gravity<D>(cloud.targets, cloud.masses(), core, true);
    const auto expected_own = long_gravity<D>(cloud.position, cloud.masses(), core, false);
    EXPECT_TRUE(agree(found.potential, expected.potential, tolerance));
    EXPECT_TRUE(agree(found.gradient, expected.gradient, tolerance));
    EXPECT_TRUE(agree(own.potential, expected_own.potential, tolerance));
    EXPECT_TRUE(agree(own.gradient, expected_own.gradient, tolerance));
  }
}

TYPED_TEST(DirectSums, EitherPartOfGravityIsThatOfBoth) {
  constexpr int D = TypeParam::value;
  const Cloud<D> cloud;
  for (const auto& core : cores()) {
    Gravity<D> gravity(direct, core);
    GravityNumbers<D> both(cloud.target_count), apart(cloud.target_count);
    gravity.at(cloud.targets, cloud.masses(), both.field());
    gravity.at(cloud.targets, cloud.masses(), {apart.potential, {}});
    gravity.at(cloud.targets, cloud.masses(), {{}, apart.gradient});
    EXPECT_TRUE(agree(apart.potential, both.potential, 1e-15));
    EXPECT_TRUE(agree(apart.gradient, both.gradient, 1e-15));
  }
}

TYPED_TEST(DirectSums, VelocityIsTheSumOverAllPairs) {
  constexpr int D = TypeParam::value;
  const Cloud<D> cloud;
  for (const auto& core : cores()) {
    SCOPED_TRACE(core);
    BiotSavart<D> sum(direct, core);
    VelocityNumbers<D> found(cloud.target_count), alone(cloud.target_count),
        own(cloud.source_count);
    sum.at(cloud.targets, cloud.vortices(), found.field());
    sum.at(cloud.targets, cloud.vortices(), {alone.velocity, {}});
    sum.at_sources(cloud.vortices(), own.field());
    const auto expected = long_velocity<D>(cloud.targets, cloud.vortices(), core);
    const auto expected_own = long_velocity<D>(cloud.position, cloud.vortices(), core);
    EXPECT_TRUE(agree(found.velocity, expected.velocity, tolerance));
    EXPECT_TRUE(agree(found.gradient, expected.gradient, tolerance));
    EXPECT_TRUE(agree(alone.velocity, expected.velocity, tolerance));
    EXPECT_TRUE(agree(own.velocity, expected_own.velocity, tolerance));
    EXPECT_TRUE(agree(own.gradient, expected_own.gradient, tolerance));
  }
}

TYPED_TEST(DirectSums, ChecksNoticeOneAlteredStrength) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto gravity = long_gravity<D>(cloud.targets, cloud.masses(), "gauss", true);
  const auto velocity = long_velocity<D>(cloud.targets, cloud.vortices(), "gauss");
  cloud.mass[117] *= 1 + 1e-9;
  cloud.circulation[117] *= 1 + 1e-9;
  GravityNumbers<D> mass(cloud.target_count);
  VelocityNumbers<D> vortex(cloud.target_count);
  Gravity<D>(direct, "gauss").at(cloud.targets, cloud.masses(), mass.field());
  BiotSavart<D>(direct, "gauss").at(cloud.targets, cloud.vortices(), vortex.field());
  EXPECT_FALSE(agree(mass.potential, gravity.potential, tolerance));
  EXPECT_FALSE(agree(mass.gradient, gravity.gradient, tolerance));
  EXPECT_FALSE(agree(vortex.velocity, velocity.velocity, tolerance));
  EXPECT_FALSE(agree(vortex.gradient, velocity.gradient, tolerance));
}

TYPED_TEST(DirectSums, SameBitsForAnyNumberOfThreads) {
  constexpr int D = TypeParam::value;
  const Cloud<D> cloud;
  const int usual = omp_get_max_threads();
  std::vector<VelocityNumbers<D>> found(3, VelocityNumbers<D>(cloud.source_count));
  for (int k = 0; k < 3; ++k) {
    omp_set_num_threads(1 << k);
    BiotSavart<D>(direct, "algebraic.4").at_sources(cloud.vortices(), found[k].field());
  }
  omp_set_num_threads(usual);
  for (int k = 1; k < 3; ++k) {
    EXPECT_EQ(found[k].velocity, found[0].velocity);
    EXPECT_EQ(found[k].gradient, found[0].gradient);
  }
}

TYPED_TEST(DirectSums, PointsOnTheSamePlaceDoNothingToEachOther) {
  constexpr int D = TypeParam::value;
  const std::vector<double> position(3 * D, 0.25), strength(3 * (D == 2 ? 1 : 3), 1.5);
  VelocityNumbers<D> vortex(3);
  BiotSavart<D>(direct).at_sources({position, strength}, vortex.field());
  EXPECT_EQ(vortex.velocity, std::vector<double>(3 * D));
  EXPECT_EQ(vortex.gradient, std::vector<double>(3 * D * D));
  GravityNumbers<D> mass(3);
  Gravity<D>(direct).at_sources({position, std::span(strength).first(3)}, mass.field());
  EXPECT_EQ(mass.potential, std::vector<double>(3));
  EXPECT_EQ(mass.gradient, std::vector<double>(3 * D));
}

/// What the InputError says that a call throws, or nothing.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.key() + ": " + error.what();
  }
  return "";
}

TYPED_TEST(DirectSums, RefusesATargetOnAPoint) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  std::copy_n(&cloud.position[500 * D], D, &cloud.targets[33 * D]);
  GravityNumbers<D> mass(cloud.target_count);
  const auto at = [&](std::string_view core) {
    return refusal(
        [&] { Gravity<D>(direct, core).at(cloud.targets, cloud.masses(), mass.field()); });
  };
  EXPECT_EQ(at("point"),
            ": target 33 stands on source 500, where the field of a point is infinite");
  EXPECT_EQ(at("gauss"), "");
}

TEST(DirectSumSettings, RefusesWhatCannotBe) {
  const auto with = [](const SumSettings& settings, std::string_view core) {
    return refusal([&] { BiotSavart<2>(settings, core); });
  };
  EXPECT_EQ(with({.method = SumMethod::power_series}, "point"),
            "method: power_series is a method of cauchy, and biot_savart has none; take direct or "
            "multipole");
  EXPECT_EQ(with(direct, "gaus"),
            "core: unknown core 'gaus'; there are point, gauss, algebraic.2, algebraic.4, "
            "algebraic.6");
  EXPECT_EQ(with({.tolerance = 0}, "point"),
            "tolerance: the tolerance of multipole must be from 1e-13 to 1e-3");
  EXPECT_EQ(with(direct, "algebraic.2"), "");
  const std::vector<double> one{1}, place{0, 0};
  std::vector<double> velocity(2);
  EXPECT_EQ(refusal([&] {
              BiotSavart<2>(direct, "gauss").at_sources({place, one}, {velocity, {}});
            }),
            "core_size: a core needs a size greater than 0");
}

}  // namespace
}  // namespace mote::test
