// X-IVAS on flows whose streamlines are known: exact where they are linear and steady, of order 1
// in the step where they change, of order 2 in the spacing where they are curved.
#include "mote/integrators/x_ivas.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "ladder.hpp"
#include "mote/integrators/forward_euler.hpp"
#include "mote/particles/failure.hpp"
#include "mote/particles/random.hpp"
#include "mote/particles/vector.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

template <int D>
using Field = std::function<Vec<D>(const Vec<D>&)>;

/// Particles on a jittered lattice of a box, in a flow of their own: an initial velocity, and the
/// acceleration at a place.
template <int D>
class Flow final : public System {
 public:
  Flow(int count, double lower, double upper, const Field<D>& initial, Field<D> acceleration)
      : acceleration_at_(std::move(acceleration)) {
    const double spacing = (upper - lower) / count;
    for (Index i = 0; i < std::lround(std::pow(count, D)); ++i) {
      Vec<D> place;
      for (Index d = 0, rest = i; d < D; ++d, rest /= count)
        place[d] =
            lower + spacing * (rest % count + 0.3 + 0.4 * uniform_random(7, position.size() + d));
      add(place, initial(place));
    }
  }
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;

  void add(const Vec<D>& place, const Vec<D>& speed) {
    position.insert(position.end(), place.data(), place.data() + D);
    velocity.insert(velocity.end(), speed.data(), speed.data() + D);
    rate_ = acceleration_ = velocity;
    drifted_ = {{{position, rate_}}};
    kicked_ = {{{velocity, acceleration_}}};
  }
  void add_wall(const Vec<D>& place, const Vec<D>& speed) {
    walls_.resize(position.size() / D);
    add(place, speed);
    walls_.push_back(1);
  }

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  int dimension() const override { return D; }
  std::array<double, 3> periods() const override { return period; }
  std::span<const std::uint8_t> walls() const override { return walls_; }
  void prepare(double) override {}
  void update_drift_rates(double) override { rate_ = velocity; }
  void update_kick_rates(double) override {
    for (std::size_t k = 0; k < position.size(); k += D)
      Vec<D>::Map(&acceleration_[k]) = acceleration_at_(Vec<D>::Map(&position[k]));
  }

  std::vector<double> position, velocity;
  std::array<double, 3> period{};

 private:
  Field<D> acceleration_at_;
  std::vector<double> rate_, acceleration_;
  std::vector<std::uint8_t> walls_;
  std::array<Evolving, 1> drifted_, kicked_;
};

template <int D>
void advance(Flow<D>& flow, double time, int steps) {
  XIvas method;
  for (int k = 0; k < steps; ++k) method.advance_one_step(flow, k * time / steps, time / steps);
}

/// Root mean square, over particles, of the distances from where a flow takes their start, in place
/// and velocity.
template <int D>
struct Error {
  double place = 0, velocity = 0;
};

template <int D>
Error<D> error_of(const Flow<D>& flow, const std::vector<double>& start, const Field<D>& path,
                  const Field<D>& velocity_of_start) {
  Error<D> error;
  for (std::size_t k = 0; k < start.size(); k += D) {
    const Vec<D> from = Vec<D>::Map(&start[k]);
    error.place += (Vec<D>::Map(&flow.position[k]) - path(from)).squaredNorm();
    error.velocity += (Vec<D>::Map(&flow.velocity[k]) - velocity_of_start(from)).squaredNorm();
  }
  const double count = static_cast<double>(start.size()) / D;
  return {std::sqrt(error.place / count), std::sqrt(error.velocity / count)};
}

/// Whether particles that turn about an axis through the middle of their box are where they should
/// be after some steps of this angle. The acceleration is `pull` times what keeps them on circles.
template <int D>
testing::AssertionResult turns(const Vec<3>& axis, double angle, double pull = 1) {
  const auto turned = [&](double by) -> Field<D> {
    return [=](const Vec<D>& x) -> Vec<D> {
      Vec<3> place = Vec<3>::Zero();
      place.head<D>() = x;
      return (Eigen::AngleAxisd(by, axis) * place).head<D>();
    };
  };
  const Field<D> speed = [=](const Vec<D>& x) -> Vec<D> {
    Vec<3> place = Vec<3>::Zero();
    place.head<D>() = x;
    return axis.cross(place).template head<D>();
  };
  Flow<D> flow(D == 2 ? 12 : 7, -1, 1, speed,
               [&](const Vec<D>& x) -> Vec<D> { return pull * speed(speed(x)); });
  const auto start = flow.position;
  constexpr int steps = 3;
  advance(flow, steps * angle, steps);
  const auto end = turned(steps * angle);
  const auto error = error_of<D>(flow, start, end, [&](const Vec<D>& x) { return speed(end(x)); });
  if (error.place <= 1e-12 && error.velocity <= 1e-12) return testing::AssertionSuccess();
  return testing::AssertionFailure() << error.place << " and " << error.velocity;
}

TEST(XIvas, FollowsRigidRotationExactlyInAnyStep) {
  const Vec<3> normal(0, 0, 1), oblique = Vec<3>(1, 2, 3).normalized();
  for (const double angle : {0.01, 0.1, 1.0, 2.5, 7.0}) {
    EXPECT_TRUE(turns<2>(normal, angle)) << angle;
    EXPECT_TRUE(turns<3>(oblique, angle)) << angle;
  }
  EXPECT_FALSE(turns<2>(normal, 1, 0.999));
}

TEST(XIvas, FollowsAConstantVelocityExactly) {
  const Vec<2> wind(3, -2);
  Flow<2> flow(
      8, 0, 1, [&](const Vec<2>&) { return wind; },
      [](const Vec<2>&) -> Vec<2> { return Vec<2>::Zero(); });
  const auto start = flow.position;
  advance(flow, 50, 2);
  const auto error = error_of<2>(
      flow, start, [&](const Vec<2>& x) -> Vec<2> { return x + 50 * wind; },
      [&](const Vec<2>&) { return wind; });
  EXPECT_LT(error.place, 1e-13 * 50 * wind.norm());
  EXPECT_LT(error.velocity, 1e-14 * wind.norm());
}

/// Oscillators x'' = -w^2 x along both axes, let go with a linear velocity: a flow that is linear
/// at all times, so that the step alone makes errors.
double error_of_oscillators(int steps) {
  constexpr double end = 1;
  const Vec<2> w(1, std::numbers::sqrt2);
  const auto initial = [](const Vec<2>& x) { return Vec<2>(0.2 * x[0] - 1.5 * x[1], x[0]); };
  Flow<2> flow(8, -1, 1, initial,
               [&](const Vec<2>& x) -> Vec<2> { return -w.cwiseProduct(w).cwiseProduct(x); });
  const auto start = flow.position;
  advance(flow, end, steps);
  const Eigen::Array2d cosine = (w * end).array().cos(), sine = (w * end).array().sin();
  const auto error = error_of<2>(
      flow, start,
      [&](const Vec<2>& x) -> Vec<2> {
        return cosine * x.array() + sine / w.array() * initial(x).array();
      },
      [&](const Vec<2>& x) -> Vec<2> {
        return -sine * w.array() * x.array() + cosine * initial(x).array();
      });
  return std::hypot(error.place, error.velocity);
}

TEST(XIvas, IsOfOrderOneWhereTheFlowChanges) {
  const Ladder rungs{{20, 40, 80, 160}, 0.05, 4e-3};
  EXPECT_TRUE(has_order(rungs, 1, error_of_oscillators));
  EXPECT_FALSE(has_order(rungs, 2, error_of_oscillators));
}

constexpr double k = 2 * std::numbers::pi;

/// Taylor-Green vortices, steady without friction.
Vec<2> vortices(const Vec<2>& x) {
  return {-std::cos(k * x[0]) * std::sin(k * x[1]), std::sin(k * x[0]) * std::cos(k * x[1])};
}
Vec<2> pull_of_vortices(const Vec<2>& x) {
  return {-k / 2 * std::sin(2 * k * x[0]), -k / 2 * std::sin(2 * k * x[1])};
}

/// Where the vortices take a point in a time, by many steps of Runge and Kutta.
Vec<2> carried(Vec<2> x, double time) {
  constexpr int steps = 50;
  const double h = time / steps;
  for (int n = 0; n < steps; ++n) {
    const Vec<2> a = vortices(x), b = vortices(x + h / 2 * a), c = vortices(x + h / 2 * b),
                 d = vortices(x + h * c);
    x += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return x;
}

/// After one step of 0.1, in which the fastest goes a tenth of the period.
double error_of_vortices(int count, double period) {
  constexpr double end = 0.1;
  Flow<2> flow(count, 0, 1, vortices, pull_of_vortices);
  flow.period = {period, period, 0};
  const auto start = flow.position;
  advance(flow, end, 1);
  return error_of<2>(
             flow, start, [](const Vec<2>& x) { return carried(x, end); },
             [](const Vec<2>& x) { return vortices(carried(x, end)); })
      .place;
}

TEST(XIvas, IsOfOrderTwoInTheSpacingOfASteadyFlow) {
  const auto error = [](int count) { return error_of_vortices(count, 1); };
  EXPECT_TRUE(has_order({{24, 48, 96}, 0.25, 5e-4}, 2, error));
}

TEST(XIvas, SeesThroughPeriodicSides) {
  EXPECT_GT(error_of_vortices(48, 0), 2 * error_of_vortices(48, 1));
}

/// How far places after one step are from where straight lines lead, at most, over the step.
double deflection(double step) {
  std::size_t drawn = 0;
  const auto noise = [&](const Vec<2>&) {
    drawn += 2;
    return Vec<2>(uniform_random(3, drawn) - 0.5, uniform_random(3, drawn + 1) - 0.5);
  };
  Flow<2> flow(20, 0, 1, noise, [](const Vec<2>&) -> Vec<2> { return Vec<2>::Zero(); });
  const auto start = flow.position, speed = flow.velocity;
  advance(flow, step, 1);
  EXPECT_EQ(flow.velocity, speed);
  double furthest = 0;
  for (std::size_t n = 0; n < start.size(); ++n)
    furthest = std::max(furthest, std::abs((flow.position[n] - start[n]) / step - speed[n]));
  return furthest;
}

/// Of velocities that differ from particle to particle at random the mesh sees only a mean. A
/// particle goes on with its own, so that a short step bends its way by the mean's gradient alone.
TEST(XIvas, KeepsWhatTheMeshDoesNotSee) {
  EXPECT_LT(deflection(1e-4), 1e-3);
  EXPECT_NEAR(deflection(1e-4) / deflection(1e-5), 10, 0.5);
}

/// Velocities and densities that drive each other, u' = -r and r' = u: sound of one wave number.
class Sound final : public System {
 public:
  Sound() = default;
  Sound(const Sound&) = delete;
  Sound& operator=(const Sound&) = delete;

  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  int dimension() const override { return 2; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {
    for (std::size_t n = 0; n < 2; ++n) {
      acceleration_[2 * n] = -density_[n];
      density_rate_[n] = velocity_[2 * n];
    }
  }
  double energy() const { return std::pow(velocity_[0], 2) + std::pow(density_[0], 2); }

 private:
  std::array<double, 4> position_{0, 0, 1, 0.5}, velocity_{1, 0, 1, 0}, acceleration_{};
  std::array<double, 2> density_{}, density_rate_{};
  std::array<Evolving, 1> drifted_{{{position_, velocity_}}};
  std::array<Evolving, 2> kicked_{{{velocity_, acceleration_}, {density_, density_rate_}}};
};

template <class Method>
double energy_after_a_thousand_steps() {
  Sound sound;
  Method method;
  for (int n = 0; n < 1000; ++n) method.advance_one_step(sound, 0.2 * n, 0.2);
  return sound.energy();
}

/// Taking turns keeps u^2 + r^2 - h u r at 1: for h = 0.2, u^2 + r^2 between 1/1.1 and 1/0.9.
TEST(XIvas, LetsSoundNeitherSwellNorFade) {
  EXPECT_NEAR(energy_after_a_thousand_steps<XIvas>(), 1, 0.112);
  EXPECT_GT(energy_after_a_thousand_steps<ForwardEuler>(), 1e10);
}

TEST(XIvas, LetsWallsGoStraightAndTheFlowAlone) {
  Flow<2> alone(10, -1, 1, vortices, pull_of_vortices);
  Flow<2> walled(10, -1, 1, vortices, pull_of_vortices);
  const Vec<2> place(0.1, 2), speed(0.3, -0.5);
  walled.add_wall(place, speed);
  advance(alone, 0.5, 1);
  advance(walled, 0.5, 1);
  const Vec<2> wall = Vec<2>::Map(&walled.position[alone.position.size()]);
  EXPECT_EQ(wall, Vec<2>(place + 0.5 * speed));
  walled.position.resize(alone.position.size());
  EXPECT_EQ(walled.position, alone.position);
}

TEST(XIvas, HasTheSameBitsOnAnyNumberOfThreads) {
  std::vector<std::vector<double>> ends;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    Flow<2> flow(70, 0, 1, vortices, pull_of_vortices);
    advance(flow, 0.1, 2);
    ends.push_back(flow.position);
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
}

TEST(XIvas, GoesOnWithFewParticles) {
  const auto away = [](const Vec<3>& x) -> Vec<3> { return 2 * x; };
  const auto nothing = [](const Vec<3>&) -> Vec<3> { return Vec<3>::Zero(); };
  Flow<3> one(1, 0, 1, away, nothing);
  const Vec<3> place = Vec<3>::Map(one.position.data());
  advance(one, 2, 2);
  EXPECT_LT((Vec<3>::Map(one.position.data()) - 5 * place).norm(), 1e-14);
  Flow<3> resting(1, 0, 1, nothing, nothing);
  advance(resting, 2, 2);
  EXPECT_EQ(Vec<3>::Map(resting.position.data()), place);
  Flow<3> walls(0, 0, 1, nothing, nothing);
  walls.add_wall(place, place);
  advance(walls, 2, 2);
  EXPECT_EQ(Vec<3>::Map(walls.position.data()), Vec<3>(place + place + place));
}

TEST(XIvas, RefusesWhatIsNotFinite) {
  Flow<2> flow(4, 0, 1, vortices, [](const Vec<2>& x) -> Vec<2> { return x / 0.0; });
  EXPECT_THROW(advance(flow, 1, 1), NumericalFailure);
}

TEST(XIvas, SaysWhatOtherSystemsLack) {
  FreeFall line({0}, {0}, {0});
  Flow<2> plane(2, 0, 1, vortices, vortices);
  EXPECT_EQ(XIvas().missing_in(line),
            "places in two or three dimensions whose velocities it moves, too");
  EXPECT_EQ(XIvas().missing_in(plane), "");
}

}  // namespace
}  // namespace mote::test
