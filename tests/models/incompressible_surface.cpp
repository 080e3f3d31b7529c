// Which particles of an incompressible fluid belong to its free surface.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "mote/particles/failure.hpp"
#include "support/incompressible_case.hpp"

namespace mote::test {
namespace {

constexpr double spacing = 0.1;

/// A box, of which the fluid fills the lower half.
IncompressibleCase half_filled(SurfaceTest test) {
  auto flow = incompressible_box<2>(spacing, {1.2, 0.6});
  flow.plan.upper[1] = 1.2;
  with_walls(flow);
  flow.options.surface_test = test;
  if (test == SurfaceTest::missing_neighbours) with_operator(flow, symmetric_mps<2>());
  return flow;
}

/// Heights of the particles that are seen at the surface, in layers from below; 0 is the lowest.
std::vector<int> layers_at_surface(const IncompressibleCase& given) {
  const auto flow = make_incompressible<2>(given);
  flow->complete_snapshot();
  std::vector<int> layers;
  for (const Index i : fluid_of(*flow))
    if (flow->cloud().values("surface")[i] != 0)
      layers.push_back(static_cast<int>(vector_of(*flow, "position", i)[1] / spacing));
  return layers;
}

struct IncompressibleSurface : testing::TestWithParam<SurfaceTest> {};

TEST_P(IncompressibleSurface, IsTheTopLayerOfABoxThatIsHalfFilled) {
  EXPECT_EQ(layers_at_surface(half_filled(GetParam())), std::vector<int>(12, 5));
}

/// The negative control: a layer more, and it is found higher.
TEST_P(IncompressibleSurface, IsHigherInABoxThatIsFuller) {
  auto flow = fluid_in_a_box<IncompressibleCase>(2, spacing, {1.2, 0.7});
  auto half = half_filled(GetParam());
  half.plan.regions = flow.plan.regions;
  EXPECT_EQ(layers_at_surface(half), std::vector<int>(12, 6));
}

TEST_P(IncompressibleSurface, IsNowhereInAPeriodicBox) {
  auto flow = half_filled(GetParam());
  flow.plan.walls.clear();
  flow.plan.upper[1] = 0.8;
  flow.plan.regions = fluid_in_a_box<IncompressibleCase>(2, spacing, {1.2, 0.8}).plan.regions;
  flow.plan.periodic = {true, true, false};
  EXPECT_THROW(make_incompressible<2>(flow), InputError);
}

const std::map<SurfaceTest, std::string> names{
    {SurfaceTest::number_density, "number_density"},
    {SurfaceTest::cone, "cone"},
    {SurfaceTest::missing_neighbours, "missing_neighbours"}};
INSTANTIATE_TEST_SUITE_P(, IncompressibleSurface,
                         testing::Values(SurfaceTest::number_density, SurfaceTest::cone,
                                         SurfaceTest::missing_neighbours),
                         [](const auto& test) { return names.at(test.param); });

}  // namespace
}  // namespace mote::test
