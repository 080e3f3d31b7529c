// ContEvol on the harmonic oscillator, against the propagators that the paper states as rational
// functions of the step.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "mote/integrators/contevol.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

/// x'' = -x, and its force as a power series.
class Oscillator final : public System, public ForceSeries {
 public:
  Oscillator(double place, double speed) : position{place}, velocity{speed} {}
  Oscillator(const Oscillator&) = delete;
  Oscillator& operator=(const Oscillator&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {}
  ForceSeries* force_series() override { return this; }

  void expand(std::span<const Eigen::VectorXd> path, std::span<Eigen::VectorXd> force,
              std::span<Eigen::MatrixXd> derivative) override {
    for (std::size_t k = 0; k < force.size(); ++k)
      force[k] = k < path.size() ? Eigen::VectorXd(-path[k]) : Eigen::VectorXd::Zero(1);
    for (auto& coefficient : derivative) coefficient = Eigen::MatrixXd::Zero(1, 1);
    if (!derivative.empty()) derivative[0](0, 0) = -1;
  }
  Eigen::VectorXd weights() const override { return Eigen::VectorXd::Ones(1); }

  std::array<double, 1> position, velocity;

 private:
  std::array<Evolving, 1> drifted_{{{position, velocity}}};
  std::array<Evolving, 1> kicked_{{{velocity, velocity}}};
};

/// [[x of x0, x of v0], [v of x0, v of v0]] after one step.
using Propagator = std::array<std::array<double, 2>, 2>;

template <class Method>
Propagator propagator(double step) {
  Propagator result;
  for (const int column : {0, 1}) {
    Oscillator oscillator(1 - column, column);
    Method().advance_one_step(oscillator, 0, step);
    result[0][column] = oscillator.position[0];
    result[1][column] = oscillator.velocity[0];
  }
  return result;
}

/// A rational function: coefficients of the powers of h, lowest first.
using Polynomial = std::vector<long double>;

long double value(const Polynomial& coefficients, long double h) {
  long double sum = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * h + *c;
  return sum;
}

/// A propagator as the paper states it: numerators for x from x0, x from v0, v from x0, v from v0,
/// and what divides each.
struct Stated {
  std::array<Polynomial, 4> numerators;
  Polynomial denominator;
  std::array<long double, 4> factors;
};

/// (2.1.10).
const Stated first_order{{Polynomial{151200, 0, -55440, 0, -1620, 0, -192, 0, 5},
                          {0, 151200, 0, -5040, 0, 60, 0, -72, 0, 1},
                          {0, 60 * -2520, 0, 60 * 84, 0, 60 * 6, 0, 60},
                          {151200, 0, -55440, 0, -1620, 0, -192, 0, 13}},
                         {75600, 0, 10080, 0, 1080, 0, 24, 0, 5},
                         {0.5L, 0.5L, 0.5L, 0.5L}};
/// (2.3.14).
const Stated direct{
    {Polynomial{1437004800, 0, -602173440, 0, 6799680, 0, 469872, 0, -8520, 0, 1125, 0, -13},
     {0, 1437004800, 0, -123171840, 0, -2324160, 0, 37296, 0, -4248, 0, 149},
     {0, -1916006400, 0, 164229120, 0, 2908800, 0, -31776, 0, 6680, 0, -198, 0, 1},
     {1916006400, 0, -802897920, 0, 9066240, 0, 626496, 0, -11360, 0, 1500, 0, -12}},
    {1916006400, 0, 155105280, 0, 6785280, 0, 312576, 0, 8464, 0, 120, 0, 7},
    {4 / 3.0L, 4 / 3.0L, 1, 1}};
/// (2.3.20), with the term in h^13 of the third that our text lacks.
const Stated indirect{
    {Polynomial{1931334451200, 0, -827714764800, 0, 16895692800, 0, 518987520, 0, -9711360, 0,
                1086048, 0, -15568, 0, 35},
     {0, 1931334451200, 0, -183936614400, 0, -1497968640, 0, 59581440, 0, -3985920, 0, 156096, 0,
      -448},
     {0, -1931334451200, 0, 183936614400, 0, 1426118400, 0, -51598080, 0, 4471200, 0, -158256, 0,
      1015},
     {1931334451200, 0, -827714764800, 0, 16895692800, 0, 558904320, 0, -10022400, 0, 1054656, 0,
      -12544}},
    {120708403200, 0, 8622028800, 0, 337478400, 0, 14065920, 0, 347760, 0, 4536, 0, 245},
    {0.0625L, 0.0625L, 0.0625L, 0.0625L}};

/// The largest difference between what a method does and what is stated.
template <class Method>
double difference(const Stated& stated, double step) {
  const Propagator found = propagator<Method>(step);
  double largest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const long double expected =
        stated.factors[k] * value(stated.numerators[k], step) / value(stated.denominator, step);
    largest = std::max(largest, static_cast<double>(std::abs(found[k / 2][k % 2] - expected)));
  }
  return largest;
}

constexpr std::array steps{0.01, 0.1, 0.25, 0.5, 1.0, 1.5};

TEST(ContEvol, HasThePropagatorsOfThePaper) {
  for (const double h : steps) {
    EXPECT_LE(difference<ContEvol1>(first_order, h), 1e-15) << h;
    EXPECT_LE(difference<ContEvol2Direct>(direct, h), 1e-15) << h;
    EXPECT_LE(difference<ContEvol2Indirect>(indirect, h), 1e-15) << h;
  }
}

TEST(ContEvol, HasNoOtherPropagator) {
  Stated lacking = indirect;
  lacking.numerators[2].back() = 0;  // as in our text
  EXPECT_GT(difference<ContEvol2Indirect>(lacking, 1), 1e-11);
  EXPECT_GT(difference<ContEvol2Indirect>(direct, 0.25), 1e-10);
  EXPECT_GT(difference<ContEvol2Direct>(first_order, 0.25), 1e-8);
}

TEST(ContEvol, SaysWhatOtherSystemsLack) {
  FreeFall system({0}, {0}, {0});
  EXPECT_EQ(ContEvol1().missing_in(system),
            "forces as power series, which point masses under their own gravity have");
  Oscillator oscillator(1, 0);
  EXPECT_EQ(ContEvol1().missing_in(oscillator), "");
}

}  // namespace
}  // namespace mote::test
