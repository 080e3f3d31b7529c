// The observed order of every operator on a line, on a lattice and on jittered points. The printed
// SPH operators lose all orders on disorder (ERRATA on (30)): that is a result, asserted like any.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "mote/neighbours/line.hpp"
#include "mote/operators/differential/apply.hpp"
#include "support/altered_operator.hpp"
#include "support/clouds.hpp"
#include "support/operators_on_a_line.hpp"

namespace mote::test {
namespace {

using Operator = DifferentialOperator<1>;
constexpr double wave_number = 2 * std::numbers::pi;

/// `count` cells on [0, 1] with their points moved by up to `jitter` spacings, and a dozen more
/// beyond each end that are neighbours only.
Points<1> cells_of_unit_line(Index count, double jitter) {
  constexpr Index beyond = 12;
  const double spacing = 1.0 / count;
  Draws draws(5);
  std::vector<double> place;
  for (Index i = -beyond - 1; i <= count + beyond; ++i)
    place.push_back((i + 0.5 + draws.uniform(-jitter, jitter)) * spacing);
  Points<1> points;
  points.resize(count + 2 * beyond, count);
  for (Index i = 0; i < points.size(); ++i) {
    const Index k = (i + beyond) % points.size() + 1;  // receivers first
    points.position[i] = place[k];
    points.length[i] = points.mass[i] = (place[k + 1] - place[k - 1]) / 2;
    points.density[i] = 1;
  }
  points.circulation = points.mass;
  points.vorticity = points.density;
  return points;
}

struct Pair {
  double gradient, laplacian;
};

/// L2 errors of the derivatives of sin(2 pi x), relative to those derivatives.
Pair errors_of(Operator& op, const Points<1>& points) {
  NeighbourLists lists;
  LineSearch().find(points, op.neighbour_rule(), lists);
  op.prepare(points, lists);
  std::vector<double> wave, first(points.receivers), second(points.receivers);
  for (const double x : points.position) wave.push_back(std::sin(wave_number * x));
  gradient<1>(op, lists, wave, first);
  laplacian<1>(op, lists, wave, second);
  Pair sum{0, 0};
  for (Index i = 0; i < points.receivers; ++i) {
    const double slope = std::cos(wave_number * points.position[i]);
    sum.gradient += std::pow(first[i] / wave_number - slope, 2);
    sum.laplacian += std::pow(second[i] / (wave_number * wave_number) + wave[i], 2);
  }
  return {std::sqrt(2 * sum.gradient / points.receivers),
          std::sqrt(2 * sum.laplacian / points.receivers)};
}

/// Orders between `count` points and `doublings` times twice as many, and the last errors.
struct Observed {
  Pair order, last;
};
Observed observe(Operator& op, Index count, int doublings, double jitter) {
  const Pair first = errors_of(op, cells_of_unit_line(count, jitter));
  const Pair last = errors_of(op, cells_of_unit_line(count << doublings, jitter));
  return {{std::log2(first.gradient / last.gradient) / doublings,
           std::log2(first.laplacian / last.laplacian) / doublings},
          last};
}

/// Whether both orders are as expected, to `tolerance`, and the last errors at most the ceilings.
testing::AssertionResult show(const Observed& found, Pair order, Pair ceiling,
                              double tolerance = 0.15) {
  if (std::abs(found.order.gradient - order.gradient) <= tolerance &&
      std::abs(found.order.laplacian - order.laplacian) <= tolerance &&
      found.last.gradient <= ceiling.gradient && found.last.laplacian <= ceiling.laplacian)
    return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "orders " << found.order.gradient << " and " << found.order.laplacian << ", errors "
         << found.last.gradient << " and " << found.last.laplacian;
}

/// What an operator shows on a lattice of 64 to 256 and on 128 to 2048 jittered points.
struct Promise {
  Pair lattice_order, lattice_ceiling, jitter_order, jitter_ceiling;
  double jitter_tolerance = 0.15;
};

/// A consistent operator of three points does this, and whatever is not named here must.
constexpr Promise consistent{{2, 2}, {1.1e-4, 5.5e-5}, {2, 1}, {2e-6, 4e-4}};

/// What falls short of it. A kernel of finite support has a floor on a lattice, where its sum is
/// not its integral; with the reaches of 3 to 5 spacings here most have come near theirs, and their
/// orders are those of two errors that cross. With a reach of 8 Lucy's Laplacian has reached it.
const std::map<std::string, Promise> promises{
    {"sph_gauss", {{2, 2}, {3.2e-4, 3.2e-4}, {0, -1}, {0.06, 60}}},
    {"sph_truncated_gauss", {{2, 1.9}, {2.6e-4, 2.8e-4}, {0, -1}, {0.07, 80}}},
    {"sph_truncated_gauss_cosine", {{2, 2.1}, {2.5e-4, 2e-4}, {0, -1}, {0.07, 80}}},
    {"sph_lucy", {{1.9, 0.35}, {2.3e-3, 0.041}, {0, -1}, {0.03, 11}}},
    {"sph_cubic_spline", {{2, 2}, {1.7e-3, 1.7e-3}, {0, -1}, {0.03, 11}}},
    {"sph_quintic_spline", {{0.7, -0.8}, {1.1e-3, 6e-3}, {0, -1}, {0.07, 80}}},
    {"sph_wendland_c2", {{0.7, 0}, {5e-3, 0.17}, {0, -1}, {0.06, 45}}},
    {"sph_wendland_c4", {{1.6, -0.4}, {7e-4, 0.014}, {0, -1}, {0.07, 60}}},
    {"sph_wendland_c6", {{1.1, 2.5}, {1.2e-3, 1.4e-4}, {0, -1}, {0.07, 75}}},
    {"mps", {{2, 2}, {1.1e-4, 5.5e-5}, {1, -1}, {3e-4, 110}}},
    {"corrected_mps", {{2, 2}, {1.6e-4, 8e-5}, {1, 1}, {2e-4, 4e-4}}},  // as corrected_sph below
    // The weight is not a kernel with its derivatives: its sums are wrong by a constant factor.
    {"mps_as_sph", {{0, 0}, {0.9, 0.9}, {0, -1}, {0.9, 40}}},
    {"least_squares_2", {{2, 2}, {1.2e-4, 8e-5}, {2, 1}, {2e-6, 4e-4}}},
    {"least_squares_3", {{4, 2}, {2e-8, 2e-4}, {3, 2}, {1e-9, 3e-6}}},
    {"least_squares_4", {{4, 4}, {6e-8, 4e-8}, {4, 3}, {2e-11, 1e-9}}}};

/// The corrected operator on any kernel: exact for linear fields in the gradient and for parabolas
/// in the Laplacian, so of order 1 on fine disorder. Where a kernel is wide its own error of order
/// 2 is not far below, and adds up to a third to what is observed.
constexpr Promise corrected_sph{{2, 2}, {4e-3, 2e-3}, {1.2, 1.2}, {2.5e-4, 2.5e-4}, 0.3};

/// The normalised difference form on any kernel: its errors are even in the spacing on a lattice,
/// and on disorder its Laplacian of a slope is not 0.
constexpr Promise morris{{2, 2}, {4e-3, 2e-3}, {1.15, -1}, {2.5e-4, 60}, 0.25};

/// The printed operator on any kernel that has no line above: what a lattice floor is depends on
/// the kernel, that disorder takes its orders away does not.
constexpr Promise printed_sph{{}, {}, {0, -1}, {1, 1000}};
bool is_new_kernel(const std::string& name) {
  return name.starts_with("sph_") && !promises.contains(name);
}

/// Where circulation is mass and vorticity density, a vortex blob is a particle of sph.
std::string without_circulation(const std::string& name) {
  const std::string blob = "vortex_blob_";
  return name.starts_with(blob) ? "sph_" + name.substr(blob.size()) : name;
}

Promise promise_of(const std::string& name) {
  if (is_new_kernel(name)) return printed_sph;
  if (name.starts_with("corrected_sph_")) return corrected_sph;
  if (name.starts_with("morris_")) return morris;
  const auto found = promises.find(name);
  return found == promises.end() ? consistent : found->second;
}

struct OperatorOrder : testing::TestWithParam<NamedOperator> {
  std::unique_ptr<Operator> op = GetParam().make();
  std::string name = without_circulation(GetParam().name);
  Promise promise = promise_of(name);
};

TEST_P(OperatorOrder, IsObservedOnALattice) {
  if (is_new_kernel(name)) GTEST_SKIP() << "no floor is known for a new kernel of sph";
  EXPECT_TRUE(show(observe(*op, 64, 2, 0), promise.lattice_order, promise.lattice_ceiling));
}

TEST_P(OperatorOrder, IsObservedOnJitteredPoints) {
  EXPECT_TRUE(show(observe(*op, 128, 4, 0.2), promise.jitter_order, promise.jitter_ceiling,
                   promise.jitter_tolerance));
}

INSTANTIATE_TEST_SUITE_P(, OperatorOrder, testing::ValuesIn(operators_on_a_line()),
                         [](const auto& op) { return op.param.name; });

TEST(OperatorOrderCheck, NoticesAWeightThatIsWrongByAThousandth) {
  AlteredOperator<1, FiniteDifference<1>> altered({}, std::nullopt, 1e-3);
  EXPECT_FALSE(
      show(observe(altered, 64, 2, 0), consistent.lattice_order, consistent.lattice_ceiling));
  EXPECT_FALSE(
      show(observe(altered, 128, 4, 0.2), consistent.jitter_order, consistent.jitter_ceiling));
}

TEST(OperatorOrderCheck, NoticesAFitOfADegreeTooLowAndAnAlteredCorrection) {
  Quadratic<1> quadratic;
  const Promise cubic = promise_of("least_squares_3");
  EXPECT_FALSE(show(observe(quadratic, 64, 2, 0), cubic.lattice_order, cubic.lattice_ceiling));
  EXPECT_FALSE(show(observe(quadratic, 128, 4, 0.2), cubic.jitter_order, cubic.jitter_ceiling));
  AlteredOperator<1, CorrectedSph<1, WendlandC2<1>>> altered({}, std::nullopt, 1e-2);
  EXPECT_FALSE(
      show(observe(altered, 64, 2, 0), corrected_sph.lattice_order, corrected_sph.lattice_ceiling));
  EXPECT_FALSE(show(observe(altered, 128, 4, 0.2), corrected_sph.jitter_order,
                    corrected_sph.jitter_ceiling, corrected_sph.jitter_tolerance));
}

// The sum of its curvature over a lattice of 8 points a smoothing length is not the integral.
TEST(Lucy, HasALaplacianFourPercentWrongOnEveryFineLattice) {
  Sph<1, Lucy<1>> lucy;
  const Observed found = observe(lucy, 512, 2, 0);
  EXPECT_NEAR(found.order.laplacian, 0, 0.05);
  EXPECT_NEAR(found.last.laplacian, 0.039, 0.001);
}

}  // namespace
}  // namespace mote::test
