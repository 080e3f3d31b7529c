#include "mote/xivas/projection.hpp"

#include <gtest/gtest.h>

#include "mote/particles/failure.hpp"
#include "mote/xivas/box_points.hpp"
#include "mote/xivas/nodal_field.hpp"
#include "xivas/meshes.hpp"

namespace mote {
namespace {

/// Particles at random places of the box, and their cells.
struct Particles {
  std::vector<double> positions;
  std::vector<Index> cells;

  Particles(const SimplexMesh<2>& mesh, int count, double upper = 1) {
    std::mt19937_64 random(4);
    for (int n = 0; n < count; ++n) {
      const Vec<2> place = random_place<2>(random, 0, upper);
      positions.insert(positions.end(), place.data(), place.data() + 2);
      cells.push_back(mesh.locate(place));
    }
  }

  std::vector<double> values(const std::function<Vec<2>(const Vec<2>&)>& field) const {
    std::vector<double> values;
    for (std::size_t p = 0; p < cells.size(); ++p) {
      const Vec<2> value = field(Vec<2>::Map(&positions[2 * p]));
      values.insert(values.end(), value.data(), value.data() + 2);
    }
    return values;
  }
};

/// The largest error at the points of a mesh.
double error(const SimplexMesh<2>& mesh, const Particles& particles, ProjectionKind kind,
             const std::function<Vec<2>(const Vec<2>&)>& field) {
  const Projection<2> projection(mesh, particles.positions, particles.cells, kind);
  EXPECT_EQ(projection.without_particles(), 0);
  EXPECT_EQ(projection.without_fit(), 0);
  const auto projected = projection.project(particles.values(field));
  const auto exact = sampled<2>(mesh, field);
  double worst = 0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    worst = std::max(worst, std::abs(projected[k] - exact[k]));
  return worst;
}

Vec<2> constant(const Vec<2>&) { return {3, -1}; }
Vec<2> linear(const Vec<2>& x) { return {1 + 2 * x[0] - x[1], 3 * x[1]}; }
Vec<2> curved(const Vec<2>& x) { return {std::sin(2 * x[0]), std::cos(x[0] + 2 * x[1])}; }

TEST(Projection, IsExactForWhatItSays) {
  const auto mesh = lattice_mesh<2>(8, 0.2);
  const Particles particles(mesh, 40 * 64);
  EXPECT_LT(error(mesh, particles, ProjectionKind::mean, constant), 1e-14);
  EXPECT_LT(error(mesh, particles, ProjectionKind::least_squares, linear), 1e-11);
  EXPECT_GT(error(mesh, particles, ProjectionKind::mean, linear), 1e-2);
}

/// The order between meshes of 8 and 32 spacings, with 40 particles a square of the lattice.
double order(ProjectionKind kind) {
  double errors[2];
  for (const int k : {0, 1}) {
    const int count = k == 0 ? 8 : 32;
    const auto mesh = lattice_mesh<2>(count, 0.2);
    errors[k] = error(mesh, Particles(mesh, 40 * count * count), kind, curved);
  }
  return std::log2(errors[0] / errors[1]) / 2;
}

TEST(Projection, HasItsOrder) {
  EXPECT_NEAR(order(ProjectionKind::mean), 1, 0.35);
  EXPECT_NEAR(order(ProjectionKind::least_squares), 2, 0.35);
}

TEST(Projection, SaysWhereItHasNoParticles) {
  const auto mesh = lattice_mesh<2>(8, 0);
  const Particles particles(mesh, 400, 0.5);
  const Projection<2> projection(mesh, particles.positions, particles.cells, ProjectionKind::mean);
  EXPECT_EQ(projection.without_particles(), 81 - 25);
  const auto projected = projection.project(particles.values(constant));
  for (std::size_t k = 0; k < projected.size(); k += 2) EXPECT_NEAR(projected[k], 3, 1e-13);
}

TEST(Projection, FallsBackToTheMeanWhereNothingIsFixed) {
  const auto mesh = lattice_mesh<2>(1, 0);
  Particles one(mesh, 1);
  const Projection<2> projection(mesh, one.positions, one.cells, ProjectionKind::least_squares);
  EXPECT_EQ(projection.without_fit(), 3);
  EXPECT_EQ(projection.without_particles(), 1);
  EXPECT_NEAR(projection.project(one.values(constant))[1], -1, 1e-15);
  EXPECT_THROW(Projection<2>(mesh, {}, {}, ProjectionKind::mean), InputError);
}

TEST(PointsInBox, FillItFromSideToSide) {
  const auto points =
      points_in_box<2>({-1, 2}, {3, 3}, {.spacing = 0.26, .jitter = 0.4, .seed = 3});
  EXPECT_EQ(points.size(), 2 * 16 * 5);
  double lowest = 9, highest = -9, moved = 0;
  for (std::size_t k = 0; k < points.size(); k += 2) {
    lowest = std::min(lowest, points[k]);
    highest = std::max(highest, points[k]);
    const double cells = (points[k] + 1) / 4 * 15;
    moved = std::max(moved, std::abs(cells - std::round(cells)));
  }
  EXPECT_EQ(lowest, -1);
  EXPECT_EQ(highest, 3);
  EXPECT_GT(moved, 0.3);
  EXPECT_LE(moved, 0.4);
}

TEST(NodalField, IsLinearInEveryCell) {
  const auto mesh = lattice_mesh<2>(6, 0.3);
  const auto values = sampled<2>(mesh, linear);
  const NodalField<2> field(mesh, values);
  const Vec<2> place(0.37, 0.61);
  const Index cell = mesh.locate(place);
  EXPECT_LT((field.value(cell, place) - linear(place)).norm(), 1e-14);
  EXPECT_LT((field.gradient(cell) - Mat<2>{{2, -1}, {0, 3}}).norm(), 1e-13);
}

}  // namespace
}  // namespace mote
