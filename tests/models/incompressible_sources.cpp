// What the right side of the pressure equation does for the density.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "support/incompressible_case.hpp"

namespace mote::test {
namespace {

constexpr double spacing = 0.05, width = 1, relaxation = 0.1;

/// A lattice at rest in a periodic box, by this source.
IncompressibleCase lattice(PressureSource source) {
  auto flow = incompressible_box<2>(spacing, {width, width}, {true, true, false});
  flow.options.source = source;
  flow.options.relaxation = relaxation;
  return without_surface(flow);
}

/// Squeezes it into a wave of the density along x, of this amplitude.
void squeeze(Incompressible<2>& flow, double amplitude) {
  const double wave_number = 2 * std::numbers::pi / width;
  const auto place = flow.cloud().position();
  for (std::size_t k = 0; k < place.size(); k += 2)
    place[k] -= amplitude / wave_number * std::sin(wave_number * place[k]);
}

/// Root mean square of how far densities are from that of the lattice.
double deviation_of(Incompressible<2>& flow) {
  flow.complete_snapshot();
  const auto density = flow.cloud().values("relative_density");
  double sum = 0;
  for (const double value : density) sum += std::pow(value - 1, 2);
  return std::sqrt(sum / static_cast<double>(density.size()));
}

/// The deviation of a squeezed lattice after every step.
std::vector<double> deviations(PressureSource source) {
  const auto flow = make_incompressible<2>(lattice(source));
  squeeze(*flow, 0.05);
  std::vector<double> found;
  for (int k = 0; k < 41; ++k) {
    take_steps(*flow, 1, 0.01);
    found.push_back(deviation_of(*flow));
  }
  EXPECT_GT(found.front(), 0.02);
  return found;
}

TEST(MixedSource, RemovesThePartOfTheDeviationThatIsAskedForInEveryStep) {
  const auto found = deviations(PressureSource::mixed);
  EXPECT_NEAR(found[20] / found[0], std::pow(1 - relaxation, 20), 2e-3);
  EXPECT_NEAR(found[40] / found[0], std::pow(1 - relaxation, 40), 4e-4);
}

/// It pulls back and does not brake: the deviation swings, less and less.
TEST(DensitySource, PullsTheDensityBack) {
  const auto found = deviations(PressureSource::density);
  EXPECT_LT(*std::max_element(found.end() - 10, found.end()), 0.3 * found[0]);
  EXPECT_GT(*std::max_element(found.begin() + 1, found.begin() + 10), 0.7 * found[0]);
}

/// The negative control.
TEST(DivergenceSource, LeavesTheDensityOfAFluidAtRest) {
  const auto found = deviations(PressureSource::divergence);
  EXPECT_NEAR(found[40] / found[0], 1, 1e-9);
}

/// Negative control: an even lattice has nothing to remove.
TEST(MixedSource, LeavesAnEvenLatticeAtRest) {
  const auto flow = make_incompressible<2>(lattice(PressureSource::mixed));
  take_steps(*flow, 10, 0.01);
  EXPECT_LT(deviation_of(*flow), 1e-13);
  EXPECT_LT(speed_of(*flow), 1e-13);
}

}  // namespace
}  // namespace mote::test
