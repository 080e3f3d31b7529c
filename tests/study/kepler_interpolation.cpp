#include "mote/study/kepler_interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace mote::test {
namespace {

struct Case {
  double eccentricity;
  int sub_intervals;
  std::array<double, 4> position;  ///< cubic, quintic, two-step, three-step
};

/// Rehman 2014, Table 2, corrected: times 100; the first row to the digits that reproduce it, the
/// others from the same definition with 40 digits (Kepler's equation by Newton's iteration, divided
/// differences with repeated nodes at k 2 pi/N), here to five.
const std::vector<Case> cases{
    {0.05, 17, {7.1358e-5, 1.8856e-7, 8.6886e-10, 2.0868e-11}},
    {0.3, 17, {0.00049168, 9.793e-6, 6.5944e-7, 1.4413e-7}},
    {0.6, 17, {0.0062845, 0.00083087, 0.00023004, 0.0001148}},
    {0.9, 17, {0.12612, 0.1509, 0.071696, 0.049995}},
    {0.05, 30, {7.4181e-6, 6.3387e-9, 5.6418e-12, 2.8297e-14}},
    {0.3, 30, {5.4578e-5, 3.6593e-7, 6.6448e-9, 5.3318e-10}},
    {0.6, 30, {0.0010004, 5.3494e-5, 8.964e-6, 3.3846e-6}},
    {0.9, 30, {0.050393, 0.036414, 0.016827, 0.011364}},
    {0.05, 79, {1.5478e-7, 1.9127e-11, 9.5583e-16, 2.7876e-19}},
    {0.3, 79, {1.1716e-6, 1.1567e-9, 1.3932e-12, 9.3481e-15}},
    {0.6, 79, {2.7021e-5, 2.426e-7, 6.5114e-9, 7.1663e-10}},
    {0.9, 79, {0.0068228, 0.0021824, 0.00083581, 0.00046207}},
    {0.05, 255, {1.4265e-9, 1.6927e-14, 2.5249e-20, 2.2102e-25}},
    {0.3, 255, {1.0846e-8, 1.0311e-12, 3.8075e-17, 8.2474e-21}},
    {0.6, 255, {2.611e-7, 2.3213e-10, 2.4106e-13, 1.4125e-15}},
    {0.9, 255, {0.00023942, 1.5515e-5, 3.0096e-6, 1.203e-6}},
    {0.05, 1080, {4.4338e-12, 2.933e-18, 5.761e-26, 6.6442e-33}},
    {0.9, 1080, {1.0739e-6, 4.7469e-9, 5.0246e-11, 2.5431e-12}},
};

/// Of positions up to 2 at the nodes, of which up to three count fully, and of the two compared.
constexpr double rounding = 1e-15;

/// Whether the four errors are those of the case, to its five digits and the rounding of positions.
testing::AssertionResult agrees(const Case& expected) {
  const auto errors = kepler_interpolation_errors(expected.eccentricity, expected.sub_intervals);
  for (std::size_t s = 0; s < errors.size(); ++s) {
    const double kept = expected.position[s], found = errors[s].position;
    if (!(std::abs(found - kept) <= 6e-5 * kept + rounding))
      return testing::AssertionFailure()
             << "e = " << expected.eccentricity << ", " << expected.sub_intervals
             << " sub-intervals, scheme " << s << ": " << found << " in place of " << kept;
  }
  return testing::AssertionSuccess();
}

TEST(KeplerInterpolation, HasTheKeptErrors) {
  for (const Case& expected : cases) EXPECT_TRUE(agrees(expected));
}

TEST(KeplerInterpolation, HasTheDigitsOfThePaper) {
  const auto errors = kepler_interpolation_errors(0.05, 17);
  EXPECT_NEAR(errors[0].position, 7.136e-5, 0.0005e-5);
  EXPECT_NEAR(errors[1].position, 1.886e-7, 0.0005e-7);
  EXPECT_NEAR(errors[2].position, 8.689e-10, 0.0005e-10);
  EXPECT_NEAR(errors[3].position, 2.087e-11, 0.0005e-11);
}

TEST(KeplerInterpolation, CheckRejectsAnotherOrbitAndAnotherNumberOfNodes) {
  EXPECT_FALSE(agrees({0.05, 18, cases[0].position}));
  EXPECT_FALSE(agrees({0.0501, 17, cases[0].position}));
  Case swapped = cases[0];
  swapped.position[2] *= 1.0002;
  EXPECT_FALSE(agrees(swapped));
}

/// Velocities are about one order worse: a derivative of the polynomial, and 1/step.
TEST(KeplerInterpolation, HasVelocitiesOneOrderWorse) {
  for (const auto& [position, velocity] : kepler_interpolation_errors(0.05, 30)) {
    EXPECT_GT(velocity, 10 * position);
    EXPECT_LT(velocity, 40 * position);
  }
}

TEST(KeplerInterpolation, LosesNothingByRoundingOnManySubIntervals) {
  const auto errors = kepler_interpolation_errors(0.3, 1080);
  for (const std::size_t s : {2, 3}) EXPECT_LE(errors[s].position, rounding);
}

TEST(KeplerInterpolation, RefusesWhatIsNoEllipse) {
  EXPECT_THROW((void)kepler_interpolation_errors(1, 17), std::domain_error);
}

}  // namespace
}  // namespace mote::test
