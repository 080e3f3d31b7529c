#include "mote/study/line_cells.hpp"

#include <gtest/gtest.h>

#include "study/printed_mesh.hpp"
#include "support/agreement.hpp"

namespace mote::test {
namespace {

constexpr const char* meshes[] = {"regular", "algebraic", "geometric", "random", "sinusoidal"};
constexpr const char* extensions[] = {"formula", "constant", "mirror", "periodic"};

ExtendedCells cells_of(const PrintedMesh& mesh) {
  const Catalogue catalogue = standard_catalogue();
  const auto lower = static_cast<double>(mesh.lower);
  return extended_cells(
      entry_named(catalogue.layouts, mesh.name),
      {lower, lower + static_cast<double>(mesh.L), mesh.N, mesh.seed, mesh.extension, mesh.beyond});
}

/// A sum of up to 140 lengths errs by less than 140 roundings.
testing::AssertionResult are_cells_of(const PrintedMesh& mesh, const ExtendedCells& cells) {
  const PrintedCells printed = printed_cells(mesh);
  if (auto right = agree(cells.length, printed.length, 1e-13); !right) return right;
  return agree(cells.centre, printed.centre, 1e-13);
}

TEST(ExtendedCells, AreThoseOfTable2) {
  for (const char* name : meshes)
    for (const char* extension : extensions)
      for (const int N : {40, 41, 7})
        for (const int beyond : {0, 1, 8, 30}) {
          const PrintedMesh mesh{name, N, -1.5L, 4, 17, extension, beyond};
          EXPECT_TRUE(are_cells_of(mesh, cells_of(mesh)))
              << name << ", " << extension << ", " << N << " and " << beyond << " cells";
        }
}

TEST(ExtendedCells, OfALineAreWithoutThoseBeyond) {
  for (const char* name : meshes)
    for (const char* extension : extensions) {
      const auto alone = cells_of({name, 40, 0, 4, 3, extension, 0});
      const auto all = cells_of({name, 40, 0, 4, 3, extension, 8});
      const std::vector<double> middle(all.length.begin() + 8, all.length.end() - 8);
      EXPECT_TRUE(agree(middle, alone.length, 1e-15)) << name << ", " << extension;
    }
}

/// The draws behind the line's own, and those of another stream below it.
TEST(ExtendedCells, DrawOnBeyondARandomMesh) {
  const auto cells = cells_of({"random", 5, 0, 4, 9, "formula", 2});
  const auto ratio = [&](int a, int b) { return cells.length[a] / cells.length[b]; };
  const auto drawn = [](std::uint64_t seed, int k) {
    return 1 + 0.0625 * static_cast<double>(draw(seed, k));
  };
  EXPECT_NEAR(ratio(7, 2), drawn(9, 5) / drawn(9, 0), 1e-14);
  EXPECT_NEAR(ratio(8, 2), drawn(9, 6) / drawn(9, 0), 1e-14);
  EXPECT_NEAR(ratio(1, 2), drawn(1009, 0) / drawn(9, 0), 1e-14);
  EXPECT_NEAR(ratio(0, 2), drawn(1009, 1) / drawn(9, 0), 1e-14);
}

TEST(ExtendedCells, OfAnAlgebraicMeshRepeatThePositiveAndSaySo) {
  const auto cells = cells_of({"algebraic", 40, 0, 4, 0, "formula", 8});
  ASSERT_EQ(cells.remarks.size(), 1u);
  EXPECT_EQ(cells.remarks[0],
            "the mesh algebraic of 40 cells has no positive length at cell -3: from there on the "
            "cell -2 is repeated");
  for (int k = 0; k < 6; ++k) EXPECT_EQ(cells.length[k], cells.length[6]) << k;
  EXPECT_NE(cells.length[6], cells.length[7]);
  for (const double length : cells.length) EXPECT_GT(length, 0);
}

/// 1/50 - 2/100 is zero: that is no length either.
TEST(ExtendedCells, OfAnAlgebraicMeshRepeatWhereTheLengthIsZero) {
  const auto cells = cells_of({"algebraic", 50, 0, 4, 0, "formula", 3});
  ASSERT_EQ(cells.remarks.size(), 1u);
  EXPECT_NE(cells.remarks[0].find("at cell -2"), std::string::npos) << cells.remarks[0];
  EXPECT_EQ(cells.length[0], cells.length[2]);
}

TEST(ExtendedCells, HaveNothingToSayElsewhere) {
  EXPECT_TRUE(cells_of({"algebraic", 40, 0, 4, 0, "formula", 2}).remarks.empty());
  for (const char* extension : {"constant", "mirror", "periodic"})
    EXPECT_TRUE(cells_of({"algebraic", 40, 0, 4, 0, extension, 8}).remarks.empty());
  for (const char* name : {"regular", "geometric", "random", "sinusoidal"})
    EXPECT_TRUE(cells_of({name, 40, 0, 4, 0, "formula", 30}).remarks.empty());
}

TEST(ExtendedCells, ChecksTellMeshesAndExtensionsApart) {
  for (const char* name : meshes)
    for (const char* other : meshes) {
      const PrintedMesh mesh{name, 40, 0, 4, 5, "formula", 8};
      PrintedMesh another = mesh;
      another.name = other;
      EXPECT_EQ(static_cast<bool>(are_cells_of(mesh, cells_of(another))), mesh.name == other);
    }
  for (const char* extension : extensions)
    for (const char* other : extensions) {
      const PrintedMesh mesh{"geometric", 40, 0, 4, 5, extension, 8};
      PrintedMesh another = mesh;
      another.extension = other;
      EXPECT_EQ(static_cast<bool>(are_cells_of(mesh, cells_of(another))), extension == other);
    }
}

TEST(ExtendedCells, ChecksNoticeAnotherStream) {
  const PrintedMesh mesh{"random", 40, 0, 4, 5, "formula", 1};
  auto cells = cells_of(mesh);
  ASSERT_TRUE(are_cells_of(mesh, cells));
  cells.length[0] *= 1 + 1e-9;
  EXPECT_FALSE(are_cells_of(mesh, cells));
}

}  // namespace
}  // namespace mote::test
