#include "mote/sums/periodic_vortices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "mote/particles/random.hpp"

namespace mote::test {
namespace {

using Complex = std::complex<long double>;
constexpr long double pi = std::numbers::pi_v<long double>;

struct Vortices {
  std::vector<double> position, circulation;
};

/// Places over more than the box; circulations that add up to 0, or `net`.
Vortices in_box(double width, double height, std::size_t count, double net = 0) {
  Vortices vortices;
  for (std::size_t i = 0; i < count; ++i) {
    vortices.position.push_back(width * (1.5 * uniform_random(2, 2 * i) - 0.2));
    vortices.position.push_back(height * (1.5 * uniform_random(2, 2 * i + 1) - 0.2));
    vortices.circulation.push_back(i % 2 == 0 ? 1 : -1);
  }
  vortices.circulation[0] += net;
  return vortices;
}

/// u - i v by rows along x, Gamma/(2 i L) cot(pi z/L), of which many are summed one by one.
Complex by_rows(const Vortices& vortices, std::size_t i, long double width, long double height,
                bool background = true) {
  Complex sum = 0;
  for (std::size_t j = 0; j < vortices.circulation.size(); ++j) {
    if (j == i) continue;
    const auto at = [&](std::size_t k) { return static_cast<long double>(vortices.position[k]); };
    const long double x = at(2 * i) - at(2 * j), difference = at(2 * i + 1) - at(2 * j + 1);
    const long double y = difference - height * std::round(difference / height);
    const long double strength = vortices.circulation[j];
    for (int m = -40; m <= 40; ++m) {
      const Complex angle = pi * Complex(x, y - m * height) / width;
      sum += strength / (2 * width) / Complex(0, 1) * std::cos(angle) / std::sin(angle);
    }
    if (background) sum += strength * y / (width * height);
  }
  return sum;
}

double error(const Vortices& vortices, double width, double height, bool background = true) {
  PeriodicVortices sum({width, height}, "point");
  std::vector<double> velocity(vortices.position.size());
  sum.at_sources({vortices.position, vortices.circulation, 0}, velocity);
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < vortices.circulation.size(); ++i) {
    const Complex expected = by_rows(vortices, i, width, height, background);
    const Complex found(velocity[2 * i], -velocity[2 * i + 1]);
    worst = std::max(worst, static_cast<double>(std::abs(found - expected)));
    largest = std::max(largest, static_cast<double>(std::abs(expected)));
  }
  return worst / largest;
}

/// Rounding grows with height over width.
TEST(PeriodicVortices, AreTheSumOfRows) {
  for (const double net : {0.0, 0.5}) {
    EXPECT_LT(error(in_box(1, 1, 21, net), 1, 1), 1e-13);
    EXPECT_LT(error(in_box(0.7, 1.9, 20, net), 0.7, 1.9), 1e-12);
  }
}

TEST(PeriodicVortices, CheckNoticesAMissingBackground) {
  EXPECT_GT(error(in_box(1, 1, 21), 1, 1, false), 1e-3);
}

/// Mirrored in x = y, vortices turn the other way round.
TEST(PeriodicVortices, DoNotDependOnHowTheBoxLies) {
  const Vortices upright = in_box(1, 1.7, 30);
  Vortices lying = upright;
  for (std::size_t i = 0; i < lying.circulation.size(); ++i) {
    std::swap(lying.position[2 * i], lying.position[2 * i + 1]);
    lying.circulation[i] *= -1;
  }
  std::vector<double> a(upright.position.size()), b(a.size());
  PeriodicVortices({1, 1.7}, "gauss").at_sources({upright.position, upright.circulation, 0.03}, a);
  PeriodicVortices({1.7, 1}, "gauss").at_sources({lying.position, lying.circulation, 0.03}, b);
  for (std::size_t i = 0; i < lying.circulation.size(); ++i) {
    EXPECT_NEAR(a[2 * i], b[2 * i + 1], 1e-13);
    EXPECT_NEAR(a[2 * i + 1], b[2 * i], 1e-13);
  }
}

/// Blobs on a lattice with the vorticity of Taylor and Green's vortices: a Gauss core multiplies
/// the wave by its Fourier transform, and the lattice makes no other error.
TEST(PeriodicVortices, MakeTaylorGreenVortices) {
  constexpr int n = 32;
  constexpr double k = 2 * std::numbers::pi, size = 1.5 / n;
  Vortices lattice;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = (i + 0.5) / n, y = (j + 0.5) / n;
      lattice.position.insert(lattice.position.end(), {x, y});
      lattice.circulation.push_back(2 * k * std::sin(k * x) * std::sin(k * y) / (n * n));
    }
  PeriodicVortices sum({1, 1}, "gauss");
  const Sources<2> sources{lattice.position, lattice.circulation, size};
  std::vector<double> velocity(lattice.position.size()), vorticity(lattice.circulation.size());
  sum.at_sources(sources, velocity);
  sum.vorticity_at_sources(sources, vorticity);
  const double smoothed = std::exp(-k * k * size * size);
  for (std::size_t i = 0; i < vorticity.size(); ++i) {
    const double x = k * lattice.position[2 * i], y = k * lattice.position[2 * i + 1];
    EXPECT_NEAR(velocity[2 * i], smoothed * std::sin(x) * std::cos(y), 1e-12);
    EXPECT_NEAR(velocity[2 * i + 1], -smoothed * std::cos(x) * std::sin(y), 1e-12);
    EXPECT_NEAR(vorticity[i], 2 * k * smoothed * std::sin(x) * std::sin(y), 1e-11);
  }
}

}  // namespace
}  // namespace mote::test
