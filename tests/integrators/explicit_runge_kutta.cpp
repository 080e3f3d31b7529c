#include "mote/integrators/explicit_runge_kutta.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mote/integrators/all.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

struct State {
  double place, velocity;
};

State operator+(State a, State b) { return {a.place + b.place, a.velocity + b.velocity}; }
State operator*(double factor, State a) { return {factor * a.place, factor * a.velocity}; }

State rate(State pendulum) { return {pendulum.velocity, -std::sin(pendulum.place)}; }

State heun(State start, double step) {
  const State first = rate(start), second = rate(start + step * first);
  return start + step * (0.5 * first + 0.5 * second);
}

State runge_kutta_4(State start, double step) {
  const State first = rate(start);
  const State second = rate(start + (step / 2) * first);
  const State third = rate(start + (step / 2) * second);
  const State fourth = rate(start + step * third);
  return start +
         step * ((1.0 / 6) * first + (1.0 / 3) * second + (1.0 / 3) * third + (1.0 / 6) * fourth);
}

/// Steps from 1 at rest; what rounding loses is forgotten after each, as the formulas do not know
/// of it.
template <class Method>
void expect_bits(State (*formula)(State, double)) {
  constexpr double step = 0.1;
  Body body = pendulum();
  Method method;
  State expected{1, 0};
  for (int k = 0; k < 100; ++k) {
    method.forget_rounding();
    method.advance_one_step(body, k * step, step);
    expected = formula(expected, step);
  }
  EXPECT_EQ(body.place(), expected.place);
  EXPECT_EQ(body.velocity(), expected.velocity);
}

TEST(ExplicitRungeKutta, HasTheBitsOfTheTextbooksFormulas) {
  expect_bits<Heun>(heun);
  expect_bits<RungeKutta4>(runge_kutta_4);
}

template <class Method>
void expect_the_same_of_many() {
  constexpr std::size_t many = 10'000;  // enough for all threads
  const auto equal = [](double value) { return std::vector<double>(many, value); };
  FreeFall one({0.3}, {0.1}, {0.01}), crowd(equal(0.3), equal(0.1), equal(0.01));
  if (!Method().missing_in(one).empty()) return;
  Method method, of_many;
  for (int k = 0; k < 3; ++k) {
    method.advance_one_step(one, 0.1 * k, 0.1);
    of_many.advance_one_step(crowd, 0.1 * k, 0.1);
  }
  EXPECT_EQ(crowd.position, equal(one.position[0])) << Method::name;
  EXPECT_EQ(crowd.velocity, equal(one.velocity[0])) << Method::name;
}

TEST(Integrator, MovesManyAsItMovesOne) {
  for_each_type(Integrators{}, []<class Method>() { expect_the_same_of_many<Method>(); });
}

}  // namespace
}  // namespace mote::test
