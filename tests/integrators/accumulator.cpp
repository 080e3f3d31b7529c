#include "mote/integrators/accumulator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mote/integrators/all.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

/// Relative error of 1 + sum of `additions` times 0.1 * 0.3, added by `add(value, rate)`.
template <class Add>
double relative_error(int additions, Add add) {
  std::vector<double> value{1}, rate{0.3};
  for (int k = 0; k < additions; ++k) add(value, rate);
  const long double exact = 1 + static_cast<long double>(0.1 * 0.3) * additions;
  return static_cast<double>(std::abs(value[0] - exact) / exact);
}

double accumulated_error(int additions) {
  Accumulator accumulator;
  return relative_error(additions, [&](std::vector<double>& value, std::vector<double>& rate) {
    const Evolving part{value, rate};
    accumulator.advance({&part, 1}, 0.1);
  });
}

double plain_error(int additions) {
  return relative_error(additions, [](std::vector<double>& value, std::vector<double>& rate) {
    value[0] += 0.1 * rate[0];
  });
}

TEST(Accumulator, KeepsItsErrorOverAMillionAdditions) {
  for (const int additions : {100, 10'000, 1'000'000})
    EXPECT_LE(accumulated_error(additions), unit) << additions;
}

TEST(Accumulator, DoesWhatPlainAdditionCannot) {
  EXPECT_GT(plain_error(1'000'000), 100 * unit);
  EXPECT_GT(plain_error(1'000'000), 10 * plain_error(1'000));
}

TEST(Accumulator, AdvancesEveryPartWithItsOwnRate) {
  std::vector<double> x{1, 2}, v{10, 20}, rho{5}, rate{-2};
  const Evolving parts[] = {{x, v}, {rho, rate}};
  Accumulator().advance(parts, 0.5);
  EXPECT_EQ(x, (std::vector<double>{6, 12}));
  EXPECT_EQ(rho, std::vector<double>{4});
}

TEST(Accumulator, AdvancesPlainlyOnAnyNumberOfThreads) {
  constexpr std::size_t count = 10'000;
  std::vector<double> value(count, 1.0 / 3), rate(count);
  for (std::size_t i = 0; i < count; ++i) rate[i] = std::sin(static_cast<double>(i));
  std::vector<double> expected = value;
  for (std::size_t i = 0; i < count; ++i) expected[i] += 0.1 * rate[i];
  const Evolving part{value, rate};
  Accumulator::advance_plainly({&part, 1}, 0.1);
  EXPECT_EQ(value, expected);
}

/// Takes `steps` steps of a fall whose every step is rounded.
void fall(Integrator& method, FreeFall& system, int steps) {
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, 0.1 * k, 0.1);
}

/// Positions and velocities after 1000 steps, then `between`, then 1000 more.
template <class Method, class Between>
std::vector<double> two_falls(Between between) {
  FreeFall system({0.3, 7}, {0.1, -0.7}, {0.01, 0.003});
  Method first, second;
  fall(first, system, 1000);
  fall(between(first, second), system, 1000);
  std::vector<double> end = system.position;
  end.insert(end.end(), system.velocity.begin(), system.velocity.end());
  return end;
}

template <class Method>
void expect_restart_after_forgetting() {
  FreeFall system({0}, {0}, {0});
  if (!Method().missing_in(system).empty()) return;
  bool has_memory = false;
  const auto restarted = two_falls<Method>([&](Method& used, Method& fresh) -> Method& {
    has_memory = !used.memory().empty();
    fresh.recall(used.memory());
    return fresh;
  });
  const auto forgetful = two_falls<Method>([](Method& used, Method&) -> Method& {
    used.forget_rounding();
    return used;
  });
  const auto remembering = two_falls<Method>([](Method& used, Method&) -> Method& { return used; });
  EXPECT_EQ(forgetful, restarted) << Method::name;
  if (has_memory) return;                             // that may hold what rounding lost
  EXPECT_NE(remembering, restarted) << Method::name;  // so the comparison above can fail
}

TEST(Integrator, ForgetsWhatMakesARestartDiffer) {
  for_each_type(Integrators{}, []<class Method>() { expect_restart_after_forgetting<Method>(); });
}

}  // namespace
}  // namespace mote::test
