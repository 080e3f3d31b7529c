#include "mote/sums/cauchy.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>

#include "mote/particles/failure.hpp"
#include "sums/clouds.hpp"

namespace mote::test {
namespace {

using Numbers = std::vector<Complex>;

Numbers complex_points(const PointCloud& cloud) {
  Numbers points;
  for (std::size_t i = 0; i < cloud.positions.size(); i += 2)
    points.emplace_back(cloud.positions[i], cloud.positions[i + 1]);
  return points;
}

Numbers strengths_of(std::size_t count) {
  Draws draws(5);
  Numbers strengths;
  for (std::size_t i = 0; i < count; ++i)
    strengths.emplace_back(draws.uniform(-1, 1), draws.uniform(-1, 1));
  return strengths;
}

/// sum_j v_j/(s - t_j) in long double, without a source on the target itself.
Complex literal_sum(const Complex& target, const Numbers& sources, const Numbers& strengths) {
  std::complex<long double> sum = 0;
  for (std::size_t j = 0; j < sources.size(); ++j) {
    if (sources[j] == target) continue;
    const auto distance = std::complex<long double>(target) - std::complex<long double>(sources[j]);
    sum += std::complex<long double>(strengths[j]) / distance;
  }
  return Complex(sum);
}

double largest(const Numbers& values) {
  double found = 0;
  for (const Complex& value : values) found = std::max(found, std::abs(value));
  return found;
}

/// Largest error at every 97th target over the largest value of all.
double relative_error(const Numbers& result, const Numbers& targets, const Numbers& sources,
                      const Numbers& strengths) {
  double error = 0;
  for (std::size_t i = 0; i < targets.size(); i += 97)
    error = std::max(error, std::abs(result[i] - literal_sum(targets[i], sources, strengths)));
  return error / largest(result);
}

Numbers at_sources(const SumSettings& settings, const Numbers& points, const Numbers& strengths) {
  Numbers result(points.size());
  Cauchy(settings).at_sources(points, strengths, result);
  return result;
}

class CauchyTolerance : public testing::TestWithParam<double> {};

TEST_P(CauchyTolerance, HoldsForPointsOfAnyKind) {
  for (const PointCloud& cloud : clouds<2>(many_points)) {
    SCOPED_TRACE(cloud.name);
    const Numbers points = complex_points(cloud), strengths = strengths_of(points.size());
    const Numbers result = at_sources({SumMethod::multipole, GetParam()}, points, strengths);
    EXPECT_LE(relative_error(result, points, points, strengths), GetParam());
  }
}

TEST_P(CauchyTolerance, HoldsForTargetsAmongTheSources) {
  Numbers sources, targets;
  for (int k = 0; k < 12000; ++k) (k % 2 == 0 ? sources : targets).emplace_back(k, 0.1 * k);
  const Numbers strengths = strengths_of(sources.size());
  Numbers result(targets.size());
  Cauchy({SumMethod::multipole, GetParam()}).at(targets, sources, strengths, result);
  EXPECT_LE(relative_error(result, targets, sources, strengths), GetParam());
}

/// A bound of 1e-13 lies at the rounding of the sums themselves.
INSTANTIATE_TEST_SUITE_P(From3To13Digits, CauchyTolerance,
                         testing::Values(1e-3, 1e-5, 1e-8, 1e-11, 1e-13));

TEST(CauchySum, OfFewTermsMissesManyDigits) {
  const Numbers points = complex_points(clouds<2>(many_points).front());
  const Numbers strengths = strengths_of(points.size());
  const Numbers result = at_sources({SumMethod::multipole, 1e-3}, points, strengths);
  EXPECT_GT(relative_error(result, points, points, strengths), 1e-8);
}

TEST(CauchySum, IsDirectToRounding) {
  for (const PointCloud& cloud : clouds<2>(many_points)) {
    SCOPED_TRACE(cloud.name);
    const Numbers points = complex_points(cloud), strengths = strengths_of(points.size());
    const Numbers result = at_sources({SumMethod::direct, 0}, points, strengths);
    EXPECT_LE(relative_error(result, points, points, strengths), 1e-14);
  }
}

TEST(CauchySum, HasTheSameBitsForAnyNumberOfThreads) {
  const int threads = omp_get_max_threads();
  for (const SumMethod method : {SumMethod::direct, SumMethod::multipole})
    for (const PointCloud& cloud : clouds<2>(20000)) {
      SCOPED_TRACE(cloud.name);
      const Numbers points = complex_points(cloud), strengths = strengths_of(points.size());
      omp_set_num_threads(1);
      const Numbers one = at_sources({method, 1e-6}, points, strengths);
      for (const int count : {2, 4}) {
        omp_set_num_threads(count);
        EXPECT_EQ(one, at_sources({method, 1e-6}, points, strengths));
      }
    }
  omp_set_num_threads(threads);
}

TEST(CauchySum, IsTheSameAtAnyScale) {
  const Numbers points = complex_points(clouds<2>(many_points).front());
  const Numbers strengths = strengths_of(points.size());
  const Numbers result = at_sources({SumMethod::multipole, 1e-8}, points, strengths);
  for (const double scale : {0x1p-400, 0x1p+400}) {
    Numbers scaled = points;
    for (Complex& point : scaled) point *= scale;
    Numbers values = at_sources({SumMethod::multipole, 1e-8}, scaled, strengths);
    for (Complex& value : values) value *= scale;
    EXPECT_LE(relative_error(values, points, points, strengths), 1e-8) << scale;
  }
}

TEST(CauchySum, RefusesPointsOfOnePlace) {
  for (const SumMethod method : {SumMethod::direct, SumMethod::multipole}) {
    Numbers points = complex_points(clouds<2>(5000).front());
    points[4321] = points[17];
    Numbers result(points.size());
    try {
      Cauchy({method, 1e-8}).at_sources(points, strengths_of(points.size()), result);
      FAIL() << "two points of one place have no sum";
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "points 18 and 4322 coincide");
    }
    const Numbers target = {points[4321]};
    EXPECT_THROW(Cauchy({method, 1e-8}).at(target, points, strengths_of(points.size()), result),
                 InputError);
  }
}

TEST(CauchySum, OfNothingOrOneIsNought) {
  Numbers none;
  Cauchy({SumMethod::multipole, 1e-8}).at_sources(none, none, none);
  const Numbers one = {{1, 2}}, strength = {{3, 4}};
  EXPECT_EQ(at_sources({SumMethod::multipole, 1e-8}, one, strength), Numbers{0});
}

}  // namespace
}  // namespace mote::test
