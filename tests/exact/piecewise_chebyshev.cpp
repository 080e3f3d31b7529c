#include "mote/exact/piecewise_chebyshev.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mote::test {
namespace {

using Function = std::function<double(double)>;

/// The largest differences of value and integral from what they should be, at 1001 places.
struct Differences {
  double value = 0, integral = 0;
};
Differences differences(const PiecewiseChebyshev& pieces, const Function& value,
                        const Function& integral) {
  Differences largest;
  const double lower = pieces.lower(), upper = pieces.upper();
  const auto integral_at = [&](double x) {
    return static_cast<double>(pieces.pieces()[pieces.piece_at(x)].integral(x));
  };
  for (int k = 0; k <= 1000; ++k) {
    const double x = lower + (upper - lower) * k / 1000;
    const ChebyshevPiece& piece = pieces.pieces()[pieces.piece_at(x)];
    largest.value = std::max(largest.value, std::abs(piece(x) - value(x)));
    const double gain = integral_at(x) - integral_at(lower);
    largest.integral = std::max(largest.integral, std::abs(gain - (integral(x) - integral(lower))));
  }
  return largest;
}

/// How near the ends of pieces come to a place.
double distance_to_ends(const PiecewiseChebyshev& pieces, double place) {
  double least = std::numeric_limits<double>::infinity();
  for (const ChebyshevPiece& piece : pieces.pieces())
    least = std::min(least, std::abs(piece.upper - place));
  return least;
}

double narrowest(const PiecewiseChebyshev& pieces) {
  double least = std::numeric_limits<double>::infinity();
  for (const ChebyshevPiece& piece : pieces.pieces())
    least = std::min(least, piece.upper - piece.lower);
  return least;
}

double ramp(double x) { return std::clamp(-x, -0.3, 0.3); }
double ramp_integral(double x) {
  return std::abs(x) < 0.3 ? -x * x / 2 : -0.045 - 0.3 * (std::abs(x) - 0.3);
}

TEST(PiecewiseChebyshev, SmoothFunctionAndIntegral) {
  PiecewiseChebyshev pieces([](double x) { return std::sin(3 * x); }, -1, 2);
  pieces.cover(-7, 9);
  const auto [value, integral] = differences(
      pieces, [](double x) { return std::sin(3 * x); },
      [](double x) { return -std::cos(3 * x) / 3; });
  EXPECT_LT(value, 2e-14);  // a rounding of 3 x up to 30 changes the sine by 4e-15
  EXPECT_LT(integral, 1e-14);
  EXPECT_LE(pieces.lower(), -7);
  EXPECT_GE(pieces.upper(), 9);
}

TEST(PiecewiseChebyshev, KinksLieBetweenPieces) {
  PiecewiseChebyshev pieces(ramp, -1, 1.1);
  const auto [value, integral] = differences(pieces, ramp, ramp_integral);
  EXPECT_LT(value, 2e-15);
  EXPECT_LT(integral, 2e-15);
  for (const double kink : {-0.3, 0.3}) EXPECT_LT(distance_to_ends(pieces, kink), 2e-15);
  EXPECT_GT(narrowest(pieces), 0.05);
}

/// The measure of the test above sees a kink that is elsewhere.
TEST(PiecewiseChebyshev, AKinkElsewhereIsFarther) {
  PiecewiseChebyshev pieces([](double x) { return ramp(x + 1e-12); }, -1, 1.1);
  EXPECT_GT(distance_to_ends(pieces, 0.3), 5e-13);
}

TEST(PiecewiseChebyshev, JumpIsFoundToTheLastPlace) {
  const auto jump = [](double x) { return x < 0.1 ? std::exp(x) : 2 - x; };
  PiecewiseChebyshev pieces(jump, -1, 1.3);
  EXPECT_LE(distance_to_ends(pieces, 0.1), std::nextafter(0.1, 1) - 0.1);
  EXPECT_GT(narrowest(pieces), 0.05);
}

TEST(PiecewiseChebyshev, KinkOfTheSlopeIsResolved) {
  const auto parabola = [](double x) { return x < 0.3 ? 0 : (x - 0.3) * (x - 0.3); };
  const auto cubic = [&](double x) { return x < 0.3 ? 0 : (x - 0.3) * parabola(x) / 3; };
  const auto [value, integral] =
      differences(PiecewiseChebyshev(parabola, -1, 1.1), parabola, cubic);
  EXPECT_LT(value, 1e-14);
  EXPECT_LT(integral, 1e-15);
}

TEST(PiecewiseChebyshev, NarrowBumpIsNotMissed) {
  const auto bump = [](double x) { return std::exp(-std::pow((x - 0.123) / 0.005, 2)); };
  PiecewiseChebyshev pieces(bump, -1, 3);
  const double sum = static_cast<double>(pieces.pieces().back().integral(pieces.upper()));
  EXPECT_NEAR(sum, 0.005 * std::sqrt(std::numbers::pi), 1e-15);
}

TEST(PiecewiseChebyshev, RefusesWhatIsNotPiecewiseSmooth) {
  const auto noise = [](double x) { return std::fmod(1e7 * std::abs(std::sin(1e7 * x)), 1.0); };
  EXPECT_THROW(PiecewiseChebyshev(noise, 0, 1), std::invalid_argument);
  EXPECT_THROW(PiecewiseChebyshev([](double x) { return std::sqrt(x); }, -1, 1),
               std::invalid_argument);
  EXPECT_THROW(PiecewiseChebyshev(ramp, 1, 1), std::invalid_argument);
  EXPECT_THROW(PiecewiseChebyshev(ramp, -1, 1).cover(0, 1e5), std::domain_error);
}

}  // namespace
}  // namespace mote::test
