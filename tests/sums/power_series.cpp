#include "mote/sums/power_series.hpp"

#include <gmock/gmock.h>
#include <omp.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "mote/particles/failure.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

using LongComplex = std::complex<long double>;
using Points = std::vector<Complex>;
using testing::HasSubstr;

/// Points between two circles about a centre, the first of them on both.
Points ring(Draws& draws, std::size_t count, Complex centre, double inner, double outer) {
  Points points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = i == 0 ? inner : i == 1 ? outer : draws.uniform(inner, outer);
    points[i] = centre + std::polar(radius, draws.uniform(-std::numbers::pi, std::numbers::pi));
  }
  return points;
}

Points strengths(Draws& draws, std::size_t count, double least = -1) {
  Points v(count);
  for (Complex& value : v) value = {draws.uniform(least, 1), draws.uniform(least, 1)};
  return v;
}

/// The largest error over the largest value.
double error_of(const Points& result, const Points& targets, const Points& sources,
                const Points& strength) {
  long double error = 0, largest = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    LongComplex sum = 0;
    for (std::size_t j = 0; j < sources.size(); ++j)
      sum += LongComplex(strength[j]) / (LongComplex(targets[i]) - LongComplex(sources[j]));
    error = std::max(error, std::abs(sum - LongComplex(result[i])));
    largest = std::max(largest, std::abs(sum));
  }
  return static_cast<double>(error / largest);
}

Points summed(const Points& targets, const Points& sources, const Points& strength,
              double tolerance) {
  Points result(targets.size());
  power_series(targets, sources, strength, tolerance, result);
  return result;
}

double error_of_series(const Points& targets, const Points& sources, const Points& strength,
                       double tolerance) {
  return error_of(summed(targets, sources, strength, tolerance), targets, sources, strength);
}

std::string refusal(const Points& targets, const Points& sources, double tolerance = 1e-8) {
  try {
    summed(targets, sources, Points(sources.size(), 1), tolerance);
    return "no refusal";
  } catch (const InputError& error) {
    return error.what();
  }
}

struct PowerSeries : testing::Test {
  Draws draws{31};
};

/// Sources inside, (11), and targets inside, (12), with strengths of any sign and of one.
TEST_F(PowerSeries, KeepsTheTolerance) {
  for (const double ratio : {0.01, 0.3, 0.7, 0.9})
    for (const double least : {-1.0, 0.5})
      for (const double tolerance : {1e-3, 1e-8, 1e-13}) {
        const Points inside = ring(draws, 70, 0, 0, ratio), outside = ring(draws, 90, 0, 1, 3);
        EXPECT_LE(error_of_series(outside, inside, strengths(draws, 70, least), tolerance),
                  tolerance);
        EXPECT_LE(error_of_series(inside, outside, strengths(draws, 90, least), tolerance),
                  tolerance);
      }
}

/// Strengths whose moments vanish leave a far smaller sum, of which the error is a part.
TEST_F(PowerSeries, KeepsTheToleranceOfASumThatCancels) {
  constexpr std::size_t count = 8;
  Points inside(count), strength(count);
  for (std::size_t j = 0; j < count; ++j) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(j) / count;
    inside[j] = std::polar(0.2, angle);
    strength[j] = std::polar(1.0, 2 * angle);
  }
  const Points outside = ring(draws, 50, 0, 1, 2);
  EXPECT_LE(error_of_series(outside, inside, strength, 1e-6), 1e-6);
}

/// The control: the sum of fewer terms, as a wider tolerance makes it, is not within the narrow.
TEST_F(PowerSeries, FewerTermsMissTheTolerance) {
  const Points inside = ring(draws, 70, 0, 0.7, 0.7), outside = ring(draws, 90, 0, 1, 1);
  const Points strength = strengths(draws, 70, 0.5);
  const double error = error_of_series(outside, inside, strength, 1e-3);
  EXPECT_LE(error, 1e-3);
  EXPECT_GT(error, 1e-8);
}

/// A source and a target on one ray are the worst case: then the bound is what comes out.
TEST_F(PowerSeries, TakesNoMoreTermsThanItNeeds) {
  const Points sources{0.5, -0.5}, targets{1, -1};
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const double error = error_of_series(targets, sources, {1, 0}, tolerance);
    EXPECT_LE(error, tolerance);
    EXPECT_GE(error, tolerance * 0.5 * (1 - 1e-6));
  }
}

TEST_F(PowerSeries, ServesSetsApartAnywhere) {
  const Complex centre(-40, 7);
  const Points cluster = ring(draws, 60, centre, 0, 1);
  const Points others = ring(draws, 60, centre + Complex(3, 0.5), 0, 1.5);
  EXPECT_LE(error_of_series(cluster, others, strengths(draws, 60), 1e-10), 1e-10);
  EXPECT_LE(error_of_series(others, cluster, strengths(draws, 60), 1e-10), 1e-10);
  const Points around = ring(draws, 60, centre, 1.5, 2);
  EXPECT_LE(error_of_series(around, cluster, strengths(draws, 60), 1e-10), 1e-10);
}

TEST_F(PowerSeries, RefusesPointsThatNoCircleParts) {
  const Points mixed = ring(draws, 60, 0, 0, 1), others = ring(draws, 60, 0, 0, 1);
  EXPECT_THAT(refusal(mixed, others), HasSubstr("needs a ratio below 1"));
  EXPECT_THAT(refusal(mixed, mixed), HasSubstr("needs a ratio below 1"));
  EXPECT_THAT(refusal({1}, {1}), HasSubstr("power_series needs sources and targets"));
}

TEST_F(PowerSeries, SaysWhichPointsLieTooNear) {
  const Points outside{{0, 2}, {0, -2}, {0, 1}, {2, 0}, {-2, 0}},
      inside{0.5, {-0.4, 0.1}, {0, 0.99}};
  const std::string message = refusal(outside, inside);
  EXPECT_THAT(message, HasSubstr("about (0, 0) source 2 lies 0.99 times as far out as target 2"));
  EXPECT_THAT(message, HasSubstr("terms, and 500 are the most that make sense"));
  EXPECT_THAT(message, HasSubstr("multipole and direct serve any points"));
  EXPECT_THAT(refusal(inside, outside),
              HasSubstr("about (0, 0) target 2 lies 0.99 times as far out as source 2"));
  EXPECT_EQ(refusal({1}, {0.9}), "no refusal");
}

TEST_F(PowerSeries, OfNothingIsNothing) {
  EXPECT_TRUE(summed({}, {1, 2}, {1, 1}, 1e-8).empty());
  EXPECT_EQ(summed({3}, {}, {}, 1e-8), Points{0});
  EXPECT_EQ(summed({3}, {1, 2}, {0, 0}, 1e-8), Points{0});
  EXPECT_LE(error_of_series({3}, {0}, {2}, 1e-14), 1e-15);
}

TEST_F(PowerSeries, SameBitsForAnyNumberOfThreads) {
  const Points inside = ring(draws, 9001, 0, 0, 0.8), outside = ring(draws, 9003, 0, 1, 2);
  const Points strength = strengths(draws, 9001);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Points one = summed(outside, inside, strength, 1e-12);
  for (const int several : {2, 4}) {
    omp_set_num_threads(several);
    EXPECT_EQ(summed(outside, inside, strength, 1e-12), one) << several << " threads";
  }
  omp_set_num_threads(threads);
}

}  // namespace
}  // namespace mote::test
