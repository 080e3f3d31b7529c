#include "mote/xivas/streamlines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mote/particles/failure.hpp"
#include "mote/xivas/linear_path.hpp"
#include "mote/xivas/matrix_exponentials.hpp"
#include "xivas/meshes.hpp"

namespace mote {
namespace {

/// A mesh and a velocity on it.
template <int D>
struct Flow {
  SimplexMesh<D> mesh;
  std::vector<double> values;
  Streamlines<D> lines{NodalField<D>(mesh, values)};

  Flow(SimplexMesh<D> of, const std::function<Vec<D>(const Vec<D>&)>& field)
      : mesh(std::move(of)), values(sampled<D>(mesh, field)) {}

  Passage<D> follow(const Vec<D>& from, double time) const {
    return lines.follow(from, mesh.locate(from), time);
  }

  Passage<D> follow_in_steps(const Vec<D>& from, double time, int steps) const {
    Passage<D> at{.position = from, .cell = mesh.locate(from)};
    for (int n = 0; n < steps; ++n) at = lines.follow(at.position, at.cell, time / steps);
    return at;
  }
};

/// dx/dt = A (x - centre), about the middle of the box.
template <int D>
struct Linear {
  Mat<D> gradient;
  Vec<D> operator()(const Vec<D>& x) const { return gradient * (x - Vec<D>::Constant(0.5)); }

  Vec<D> after(const Vec<D>& from, double time) const {
    using Exact = Eigen::Matrix<long double, D, D>;
    const auto of =
        matrix_exponentials<long double, D>(Exact(gradient.template cast<long double>()), time);
    return (from.template cast<long double>() +
            of.q * (gradient * (from - Vec<D>::Constant(0.5))).template cast<long double>())
        .template cast<double>();
  }
};

Linear<2> rotation() { return {Mat<2>{{0, -1}, {1, 0}}}; }
Linear<3> screw() { return {Mat<3>{{-0.2, -2, 0.3}, {2, -0.1, 0}, {0, 0.1, -0.3}}}; }

/// The largest error of so many points followed in a linear field for so long, in so many steps.
template <int D>
double worst_error(const Linear<D>& field, double jitter, double time, int steps,
                   int points = 100) {
  const Flow<D> flow(lattice_mesh<D>(D == 2 ? 12 : 6, jitter), field);
  std::mt19937_64 random(3);
  double worst = 0;
  for (int n = 0; n < points; ++n) {
    const Vec<D> from = random_place<D>(random, 0.25, 0.75);
    const auto end = flow.follow_in_steps(from, time, steps);
    EXPECT_FALSE(end.left);
    worst = std::max(worst, (end.position - field.after(from, time)).norm());
  }
  return worst;
}

TEST(Streamlines, OfLinearFieldsAreExactForAnyStep) {
  for (const double jitter : {0.0, 0.3})
    for (const int steps : {1, 7, 100}) {
      EXPECT_LT(worst_error(rotation(), jitter, 2 * std::numbers::pi, steps), 1e-13);
      EXPECT_LT(worst_error(screw(), jitter, 5, steps), 1e-13);
    }
}

/// What rounding of the time and of the gradients on the way explains: some eps T |u|, however many
/// cells are crossed.
TEST(Streamlines, KeepTheirTimeOverManyCrossings) {
  const double time = 400 * std::numbers::pi, speed = 0.25 * std::numbers::sqrt2;
  const double unit = std::numeric_limits<double>::epsilon() * time * speed;
  EXPECT_LT(worst_error(rotation(), 0, time, 1, 10), 2 * unit);
  EXPECT_LT(worst_error(rotation(), 0.3, time, 1, 10), 2 * unit);
}

TEST(Streamlines, OfConstantFieldsAreExact) {
  const Flow<2> flow(lattice_mesh<2>(10, 0.3), [](const Vec<2>&) { return Vec<2>(0.3, -0.1); });
  const auto end = flow.follow({0.1, 0.8}, 2);
  EXPECT_LT((end.position - Vec<2>(0.7, 0.6)).norm(), 1e-15);
}

/// A vortex in a box that nothing leaves.
Vec<2> cellular(const Vec<2>& x) {
  using std::numbers::pi;
  return {std::sin(pi * x[0]) * std::cos(pi * x[1]), -std::cos(pi * x[0]) * std::sin(pi * x[1])};
}

/// In every plane one, so that the faces of the box are stream surfaces.
Vec<3> cellular_3d(const Vec<3>& x) {
  using std::numbers::pi;
  const auto s = [&](int d) { return std::sin(pi * x[d]); };
  const auto c = [&](int d) { return std::cos(pi * x[d]); };
  return {s(0) * c(1) * c(2), c(0) * s(1) * c(2), -2 * c(0) * c(1) * s(2)};
}

/// By many small steps of the classical Runge-Kutta method in the piecewise linear field itself.
template <int D>
Vec<D> by_small_steps(const Flow<D>& flow, Vec<D> x, double time, int steps) {
  Index cell = flow.mesh.locate(x);
  const double h = time / steps;
  const auto u = [&](const Vec<D>& place) {
    cell = flow.mesh.locate(place, cell);
    return flow.lines.velocity().value(cell, place);
  };
  for (int n = 0; n < steps; ++n) {
    const Vec<D> a = u(x), b = u(x + h / 2 * a), c = u(x + h / 2 * b), d = u(x + h * c);
    x += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return x;
}

template <int D>
void expect_piecewise_exact(const Flow<D>& flow, double time) {
  std::mt19937_64 random(9);
  for (int n = 0; n < 5; ++n) {
    const Vec<D> from = random_place<D>(random, 0.1, 0.9);
    const auto once = flow.follow(from, time);
    EXPECT_GT(once.crossings, 1);
    EXPECT_LT((once.position - by_small_steps(flow, from, time, 20000)).norm(), 1e-8);
    EXPECT_LT((once.position - flow.follow_in_steps(from, time, 333).position).norm(), 1e-12);
  }
}

TEST(Streamlines, OfPiecewiseLinearFieldsAreExact) {
  expect_piecewise_exact(Flow<2>(lattice_mesh<2>(10, 0.3), cellular), 2);
  expect_piecewise_exact(Flow<3>(lattice_mesh<3>(6, 0.2), cellular_3d), 2);
}

TEST(Streamlines, CrossFacesInOrder) {
  const Flow<2> flow(lattice_mesh<2>(10, 0.3), cellular);
  const Vec<2> from(0.2, 0.3);
  Index cell = flow.mesh.locate(from);
  int crossings = 0;
  for (int n = 1; n <= 4000; ++n) {
    const auto at = flow.follow(from, n * 5e-4);
    if (at.cell == cell) continue;
    const auto& faces = flow.mesh.cell(cell).faces;
    EXPECT_TRUE(
        std::ranges::any_of(faces, [&](const auto& face) { return face.neighbour == at.cell; }));
    cell = at.cell;
    EXPECT_EQ(at.crossings, ++crossings);
  }
  EXPECT_GT(crossings, 10);
}

template <int D>
void expect_none_lost(const Flow<D>& flow, double courant, int count) {
  std::mt19937_64 random(13);
  const double step = courant / flow.lines.courant_number(1);
  for (int n = 0; n < count; ++n) {
    auto at = flow.follow(random_place<D>(random), 0);
    for (int s = 0; s < 3; ++s) {
      at = flow.lines.follow(at.position, at.cell, step);
      EXPECT_FALSE(at.left);
      EXPECT_EQ(at.time.value(), step);
      for (const auto& face : flow.mesh.cell(at.cell).faces)
        ASSERT_LE(face.distance(at.position), flow.mesh.tolerance());
    }
  }
}

TEST(Streamlines, LoseNobodyInStepsOf25TimesTheCourantLimit) {
  for (const double jitter : {0.0, 0.3}) {
    expect_none_lost(Flow<2>(lattice_mesh<2>(10, jitter), cellular), 25, 200);
    expect_none_lost(Flow<3>(lattice_mesh<3>(5, jitter), cellular_3d), 25, 100);
  }
  expect_none_lost(Flow<2>(lattice_mesh<2>(10, 0.3), cellular), 2500, 20);
}

TEST(Streamlines, MayStartOnAndRunAlongFacesEdgesAndCorners) {
  const auto mesh = lattice_mesh<3>(4, 0);
  for (const Vec<3>& velocity :
       {Vec<3>(1, 0, 0), Vec<3>(1, 1, 0), Vec<3>(1, 1, 1), Vec<3>(0, -1, 1)}) {
    const Flow<3> flow(mesh, [&](const Vec<3>&) { return velocity; });
    for (const Vec<3>& from :
         {Vec<3>(0.25, 0.5, 0.25), Vec<3>(0.25, 0.625, 0.25), Vec<3>(0.3, 0.5, 0.3)})
      for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto& faces = mesh.cell(cell).faces;
        if (std::ranges::any_of(faces, [&](const auto& f) { return f.distance(from) > 1e-15; }))
          continue;
        const auto end = flow.lines.follow(from, cell, 0.375);
        EXPECT_FALSE(end.left);
        EXPECT_LT((end.position - from - 0.375 * velocity).norm(), 1e-15);
      }
  }
}

/// A parabola y = 1/2 + above - (x - 1/2)^2 that touches or crosses the line y = 1/2 of a lattice.
int crossings_of_parabola(double above) {
  const Flow<2> flow(SimplexMesh<2>({-1, 0.5, 2, 0.5, 0.5, -3, 0.5, 4}),
                     [](const Vec<2>& x) { return Vec<2>(1, 1 - 2 * x[0]); });
  const Vec<2> from(0.1, 0.34 + above);
  const auto end = flow.follow(from, 0.8);
  EXPECT_LT((end.position - Vec<2>(0.9, 0.34 + above)).norm(), 1e-14);
  return end.crossings;
}

TEST(Streamlines, MayTouchAFace) {
  EXPECT_EQ(crossings_of_parabola(1e-3), 2);
  EXPECT_EQ(crossings_of_parabola(1e-12), 2);
  EXPECT_EQ(crossings_of_parabola(0), 0);
  EXPECT_EQ(crossings_of_parabola(-1e-12), 0);
  EXPECT_EQ(crossings_of_parabola(-1e-3), 0);
}

TEST(Streamlines, EndAtStagnationPoints) {
  const Linear<2> saddle{Mat<2>{{-1, 0}, {0, 1}}};
  const auto moved = [&](double jitter, double time) {
    const Flow<2> flow(lattice_mesh<2>(8, jitter), saddle);
    return (flow.follow({0.5, 0.5}, time).position - Vec<2>(0.5, 0.5)).norm();
  };
  EXPECT_LT(moved(0, 1e3), 1e-15);  // it is a point of the mesh
  EXPECT_LT(moved(0.3, 20), 8 * std::numeric_limits<double>::epsilon() * std::exp(20));
  const Linear<3> sink{Mat<3>{{-1, 0, 0}, {0, -2, 0}, {0, 0, -3}}};
  const Flow<3> flow(lattice_mesh<3>(4, 0), sink);
  EXPECT_LT((flow.follow({0.9, 0.8, 0.1}, 100).position - Vec<3>::Constant(0.5)).norm(), 1e-15);
}

TEST(Streamlines, SayWhenAndWhereTheyLeave) {
  const Flow<2> flow(lattice_mesh<2>(8, 0.3), [](const Vec<2>&) { return Vec<2>(2, 0.25); });
  const auto end = flow.follow({0.5, 0.5}, 7);
  EXPECT_TRUE(end.left);
  EXPECT_NEAR(end.time.value(), 0.25, 1e-14);
  EXPECT_LT((end.position - Vec<2>(1, 0.5625)).norm(), 2 * flow.mesh.tolerance());
}

TEST(Streamlines, IntegrateAccelerations) {
  const auto mesh = lattice_mesh<2>(12, 0.3);
  const auto turning = sampled<2>(mesh, rotation());
  const auto pull = sampled<2>(mesh, [](const Vec<2>& x) { return Vec<2>(Vec<2>(0.5, 0.5) - x); });
  const Streamlines<2> lines(NodalField<2>(mesh, turning), NodalField<2>(mesh, pull));
  const Vec<2> from(0.7, 0.6);
  const auto end = lines.follow(from, mesh.locate(from), 2.5);
  const Vec<2> gain = rotation()(end.position) - rotation()(from);
  EXPECT_LT((end.gain - gain).norm(), 1e-14);
}

TEST(Streamlines, RefuseWhatIsNotFinite) {
  const Flow<2> flow(lattice_mesh<2>(3, 0), [](const Vec<2>&) { return Vec<2>(std::nan(""), 0); });
  EXPECT_THROW(flow.follow({0.5, 0.4}, 1), NumericalFailure);
}

TEST(Streamlines, RefuseWhatHasNoFiniteSquareAndSaySo) {
  const auto of_speed = [](double speed) {
    return Flow<2>(lattice_mesh<2>(3, 0), [=](const Vec<2>&) { return Vec<2>(speed, 0); });
  };
  EXPECT_TRUE(of_speed(1e150).follow({0.5, 0.4}, 1).left);
  try {
    of_speed(1e200).follow({0.5, 0.4}, 1);
    FAIL() << "followed a velocity without a finite square";
  } catch (const NumericalFailure& failure) {
    EXPECT_THAT(failure.what(), testing::HasSubstr("square of the velocity"));
  }
}

TEST(FirstCrossing, IsNeverPassed) {
  const double limit = 1e-14;
  const std::vector<double> twice{-0.06, 0.5, -1};  // 0 at 0.2 and 0.3
  const std::vector<double> tangent{-0.25, 1, -1};  // touches 0 at 0.5
  const std::vector<double> below{-0.25 - 1e-9, 1, -1};
  EXPECT_NEAR(first_crossing(twice, limit, 1), 0.2, 1e-13);
  EXPECT_NEAR(first_crossing(twice, 2e-3, 1), 0.22, 0.007);  // 1e-3 at 0.2113, 2e-3 at 0.2276
  EXPECT_GE(first_crossing(twice, 6e-3, 1), 1);
  EXPECT_GE(first_crossing(tangent, limit, 1), 1);
  EXPECT_GE(first_crossing(below, limit, 1), 1);
  EXPECT_EQ(first_crossing(std::vector<double>{1e-3, -1}, limit, 1), 0);
}

}  // namespace
}  // namespace mote
