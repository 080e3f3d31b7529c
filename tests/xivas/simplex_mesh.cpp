#include "mote/xivas/simplex_mesh.hpp"

#include <gtest/gtest.h>

#include "mote/particles/failure.hpp"
#include "xivas/meshes.hpp"

namespace mote {
namespace {

template <int D>
void expect_whole(const SimplexMesh<D>& mesh) {
  double volume = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const MeshCell<D>& cell = mesh.cell(c);
    volume += mesh.volume(c);
    Vec<D> sum = Vec<D>::Zero();
    double steepest = 0;
    for (std::size_t f = 0; f <= D; ++f) {
      const MeshFace<D>& face = cell.faces[f];
      sum += face.gradient();
      steepest = std::max(steepest, 1 / face.height);
      EXPECT_NEAR(face.distance(mesh.point(cell.vertices[f])), -face.height, 1e-13);
      EXPECT_NEAR(face.distance(mesh.point(cell.vertices[(f + 2) % (D + 1)])), 0, 1e-13);
      if (face.neighbour == no_cell) continue;
      const auto& back = mesh.cell(face.neighbour).faces;
      EXPECT_TRUE(std::ranges::any_of(back, [&](const auto& other) {
        return other.neighbour == c && (other.normal + face.normal).norm() < 1e-9;
      }));
    }
    EXPECT_LT(sum.norm(), 1e-12 * steepest);
  }
  EXPECT_NEAR(volume, 1, 1e-12);
}

TEST(SimplexMesh, FillsTheHullOfLatticesAndOfScatteredPoints) {
  for (const double jitter : {0.0, 1e-13, 0.3}) {
    expect_whole(lattice_mesh<2>(8, jitter));
    expect_whole(lattice_mesh<3>(4, jitter));
  }
}

TEST(SimplexMesh, OfALatticeHasTwoTrianglesASquare) {
  EXPECT_EQ(lattice_mesh<2>(8, 0).cell_count(), 128);
}

template <int D>
void expect_found(const SimplexMesh<D>& mesh) {
  std::mt19937_64 random(11);
  Index cell = 0;
  for (int n = 0; n < 300; ++n) {
    const Vec<D> place = random_place<D>(random);
    cell = mesh.locate(place, cell);
    ASSERT_NE(cell, no_cell);
    for (const auto& face : mesh.cell(cell).faces)
      EXPECT_LE(face.distance(place), mesh.tolerance());
  }
}

TEST(SimplexMesh, FindsPlaces) {
  for (const double jitter : {0.0, 0.3}) {
    expect_found(lattice_mesh<2>(8, jitter));
    expect_found(lattice_mesh<3>(4, jitter));
  }
}

TEST(SimplexMesh, FindsItsOwnPointsAndTheMiddlesOfTheirFaces) {
  const auto mesh = lattice_mesh<3>(4, 0);
  for (Index i = 0; i < mesh.point_count(); ++i) {
    EXPECT_NE(mesh.locate(mesh.point(i), 17), no_cell);
    EXPECT_NE(mesh.locate(0.5 * (mesh.point(i) + mesh.point(0)), 17), no_cell);
  }
}

TEST(SimplexMesh, SaysWhatIsOutside) {
  const auto mesh = lattice_mesh<2>(8, 0.2);
  EXPECT_EQ(mesh.locate({1.01, 0.5}), no_cell);
  EXPECT_EQ(mesh.locate({-1e-12, 0.5}, 60), no_cell);
  EXPECT_NE(mesh.locate({0, 0.5}, 60), no_cell);
}

TEST(SimplexMesh, RefusesPointsThatFillNothing) {
  EXPECT_THROW(SimplexMesh<2>({0, 0, 1, 1, 2, 2, 3, 3}), InputError);
  EXPECT_THROW(SimplexMesh<3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}), InputError);
  EXPECT_THROW(SimplexMesh<2>({0, 0, 1, 0, 0, 1, 1, 0}), InputError);
}

}  // namespace
}  // namespace mote
