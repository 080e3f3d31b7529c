// The pressure equation that a step solves, from its words, and what it takes out of a velocity.

#include <gtest/gtest.h>

#include <numbers>

#include "support/incompressible_case.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

constexpr double wave_number = 2 * std::numbers::pi;

/// n and lambda of a square lattice, by the smoothing length, in spacings.
std::pair<double, double> constants_of_lattice(double smoothing_length) {
  double n = 0, moment = 0;
  for (int x = -9; x <= 9; ++x)
    for (int y = -9; y <= 9; ++y) {
      const double r = std::hypot(x, y);
      if (r == 0 || r >= smoothing_length) continue;
      n += smoothing_length / r - 1;
      moment += r * r * (smoothing_length / r - 1);
    }
  return {n, moment / n};
}

constexpr double spacing = 0.1, width = 1, step = 0.02, density = 3;

/// Irregular particles in a periodic box, whose velocities are unlike their neighbours'.
IncompressibleCase crowd(double tolerance) {
  auto flow = incompressible_box<2>(spacing, {width, width}, {true, true, false});
  flow.options.density = density;
  flow.options.tolerance = tolerance;
  flow.options.source = PressureSource::divergence;
  with_operator(without_surface(flow, 7), symmetric_mps<2>());
  auto draws = std::make_shared<Draws>(9);
  flow.velocity = [=](const Place&) {
    return Triple{draws->uniform(-1, 1), draws->uniform(-1, 1)};
  };
  return in_disorder(flow);
}

/// The state in the middle of a step, by the particles' ids.
struct Middle {
  std::vector<Vec<2>> place, velocity;      ///< where the pressure acts, and before it does
  std::vector<double> pressure, deviation;  ///< the latter of the density
};

Middle middle_of_first_step(Incompressible<2>& flow) {
  const auto count = static_cast<std::size_t>(flow.cloud().count());
  Middle middle{std::vector<Vec<2>>(count), std::vector<Vec<2>>(count), std::vector<double>(count),
                std::vector<double>(count)};
  const auto id = [&](Index i) { return static_cast<std::size_t>(flow.cloud().values("id")[i]); };
  for (Index i = 0; i < flow.cloud().count(); ++i)
    middle.velocity[id(i)] = vector_of(flow, "velocity", i);
  take_steps(flow, 1, step);
  flow.complete_snapshot();
  for (Index i = 0; i < flow.cloud().count(); ++i) {
    middle.place[id(i)] =
        vector_of(flow, "position", i) - step / 2 * vector_of(flow, "velocity", i);
    middle.deviation[id(i)] = flow.cloud().values("relative_density")[i] - 1;
    middle.pressure[id(i)] = flow.cloud().values("pressure")[i];
  }
  return middle;
}

/// The right side of the pressure equation over rho/dt, from grad v and the density's deviation.
using Source = double (*)(const Mat<2>& slope, double deviation);

double divergence(const Mat<2>& slope, double) {
  return slope.trace() - step / 2 * (slope * slope).trace();
}

/// Khayyer & Gotoh (2011), with the relaxation of the options' default.
double mixed(const Mat<2>& slope, double deviation) {
  return divergence(slope, 0) + std::abs(deviation) * slope.trace() -
         (0.01 + std::abs(step * slope.trace())) * deviation / step;
}

/// What is left of lap p = rho/dt source less its mean, relative to the right side, by the literal
/// sums of mps with the constants of a lattice.
double misfit(const Middle& state, Source source = divergence) {
  const double reach = 3.1 * spacing;
  const auto [n, lambda] = constants_of_lattice(3.1);
  const std::size_t count = state.place.size();
  Eigen::VectorXd left = Eigen::VectorXd::Zero(count), right(count);
  for (std::size_t i = 0; i < count; ++i) {
    Mat<2> slope = Mat<2>::Zero();
    for (std::size_t j = 0; j < count; ++j) {
      Vec<2> x = state.place[j] - state.place[i];
      for (double& d : x) d -= width * std::round(d / width);
      const double r = x.norm();
      if (j == i || r >= reach) continue;
      const double w = reach / r - 1;
      left[i] += 4 / (lambda * spacing * spacing * n) * w * (state.pressure[j] - state.pressure[i]);
      slope += 2 / n * w / (r * r) * x * (state.velocity[j] - state.velocity[i]).transpose();
    }
    right[i] = density / step * source(slope, state.deviation[i]);
  }
  right.array() -= right.mean();
  return (left - right).norm() / right.norm();
}

TEST(PressureEquation, IsSolvedAsFarAsIsAskedFor) {
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    const auto flow = make_incompressible<2>(crowd(tolerance));
    const double left = misfit(middle_of_first_step(*flow));
    EXPECT_LT(left, 1.01 * tolerance);
    EXPECT_GT(left, 1e-4 * tolerance);  // a looser tolerance leaves more
    EXPECT_NEAR(told(*flow, "residual"), left, 0.01 * left + 1e-13);
  }
}

TEST(PressureEquation, GivesTheMeanPressureThatIsAskedFor) {
  const Middle state = middle_of_first_step(*make_incompressible<2>(crowd(1e-12)));
  const auto count = static_cast<double>(state.pressure.size());
  double sum = 0, size = 0;
  for (const double pressure : state.pressure) {
    sum += pressure;
    size += std::abs(pressure);
  }
  EXPECT_NEAR(sum / count, 7, 1e-13 * size / count);
}

/// Negative controls: without the term of second order in the step, and with one of another source.
TEST(PressureEquation, IsNoOtherEquation) {
  const Middle state = middle_of_first_step(*make_incompressible<2>(crowd(1e-12)));
  EXPECT_GT(misfit(state, [](const Mat<2>& slope, double) { return slope.trace(); }), 1e-3);
  EXPECT_GT(misfit(state, mixed), 1e-3);
}

TEST(PressureEquation, CompensatesWhatIsLeftOfErrorsWhereSourcesAreMixed) {
  auto flow = crowd(1e-12);
  flow.options.source = PressureSource::mixed;
  EXPECT_LT(misfit(middle_of_first_step(*make_incompressible<2>(flow)), mixed), 1.01e-12);
}

/// A slow velocity on `count` irregular particles a side.
IncompressibleCase slow_flow(int count, const std::function<Triple(const Place&)>& velocity) {
  auto flow = incompressible_box<2>(1.0 / count, {1, 1}, {true, true, false});
  flow.options.source = PressureSource::divergence;
  flow.options.tolerance = 1e-10;
  flow.velocity = velocity;
  return in_disorder(without_surface(flow));
}

/// The part of its velocity that a short step leaves.
double part_left(const IncompressibleCase& flow) {
  const auto made = make_incompressible<2>(flow);
  const double before = told(*made, "kinetic_energy");
  take_steps(*made, 1, 1e-3 * flow.plan.spacing);
  return std::sqrt(told(*made, "kinetic_energy") / before);
}

Triple gradient_of_wave(const Place& at) {
  return {std::sin(wave_number * at[0]) * std::cos(wave_number * at[1]),
          std::cos(wave_number * at[0]) * std::sin(wave_number * at[1])};
}

Triple curl_of_wave(const Place& at) {
  const Triple gradient = gradient_of_wave(at);
  return {-gradient[1], gradient[0]};
}

double order_of(double coarse, double fine) { return std::log2(coarse / fine); }

/// To the order of the corrected operator on disorder, 1.8 between these spacings.
TEST(Projection, TakesOutAGradient) {
  const double coarse = part_left(slow_flow(16, gradient_of_wave)),
               fine = part_left(slow_flow(64, gradient_of_wave));
  EXPECT_NEAR(order_of(coarse, fine) / 2, 1.8, 0.15) << coarse << ", " << fine;
  EXPECT_LT(fine, 0.012);
}

TEST(Projection, LeavesAVelocityWithoutDivergence) {
  EXPECT_NEAR(part_left(slow_flow(64, curl_of_wave)), 1, 1e-4);
}

/// Negative control: the weights of mps have an error on disorder that no spacing cures.
TEST(Projection, TakesOutAGradientToNoOrderByMps) {
  const auto left = [](int count) {
    auto flow = slow_flow(count, gradient_of_wave);
    return part_left(with_operator(flow, symmetric_mps<2>()));
  };
  const double coarse = left(16), fine = left(64);
  EXPECT_LT(order_of(coarse, fine) / 2, 0.5) << coarse << ", " << fine;
  EXPECT_GT(fine, 0.05);
}

}  // namespace
}  // namespace mote::test
