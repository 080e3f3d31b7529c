#include "mote/input/point_table.hpp"

#include <gmock/gmock.h>

#include "input/refusal.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;

/// What an action throws as an InputError.
template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PointTable, FindsColumnsByName) {
  const PointTable table{{{"x", {1, 2}}, {"mass", {3, 4}}}};
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_TRUE(table.has("mass"));
  EXPECT_FALSE(table.has("y"));
  EXPECT_THAT(table.column("mass"), ElementsAre(3, 4));
  EXPECT_EQ(error_of([&] { table.column("y"); }), "there is no column y; there are: x, mass");
}

TEST(PointTable, WithoutColumnsHasNoRows) {
  EXPECT_EQ(PointTable{}.rows(), 0u);
  EXPECT_EQ(error_of([] { check_numbers({}); }), "there are no points");
}

TEST(PointTable, NamesComponents) {
  EXPECT_THAT(component_names("v", 1), ElementsAre("v"));
  EXPECT_THAT(component_names("v", 2), ElementsAre("v_x", "v_y"));
  EXPECT_THAT(component_names("v", 3), ElementsAre("v_x", "v_y", "v_z"));
  EXPECT_THAT(component_names("v", 4), ElementsAre("v_0", "v_1", "v_2", "v_3"));
  EXPECT_THAT(coordinate_names("p", 2), ElementsAre("x", "y"));
  EXPECT_EQ(error_of([] { coordinate_names("p", 4); }),
            "'p' has 4 numbers a point; a position has 1 to 3");
  EXPECT_EQ(error_of([] { coordinate_names("p", 0); }),
            "'p' has 0 numbers a point; a position has 1 to 3");
}

TEST(PointTable, TakesArraysPointByPoint) {
  PointTable table;
  append(table, "p", {"x", "y"}, std::vector<double>{1, 2, 3, 4});
  EXPECT_THAT(table.column("x"), ElementsAre(1, 3));
  EXPECT_THAT(table.column("y"), ElementsAre(2, 4));
  const std::vector<double> three{5, 6, 7};
  EXPECT_EQ(error_of([&] { append(table, "m", {"m"}, three); }),
            "'m' has length 3, but x has length 2");
  EXPECT_EQ(error_of([&] {
              append(table, "q", {"q", "y"}, std::vector<double>{1, 2, 3, 4});
            }),
            "the column 'y' is there twice");
  EXPECT_EQ(error_of([&] { append(table, "m", {}, three); }), "'m' has no numbers");
}

TEST(PointTable, DropsCoordinatesThatAreZero) {
  PointTable line{{{"x", {0, 0}}, {"y", {0, -0.0}}, {"z", {0, 0}}, {"v_z", {0, 0}}}};
  drop_zero_coordinates(line);
  EXPECT_EQ(names_of(line), "x,v_z");
  PointTable plane{{{"x", {0, 0}}, {"y", {0, 1e-300}}, {"z", {0, 0}}}};
  drop_zero_coordinates(plane);
  EXPECT_EQ(names_of(plane), "x,y");
}

TEST(PointTable, KeepsAZeroYWhereZIsNot) {
  PointTable space{{{"x", {0, 1}}, {"y", {0, 0}}, {"z", {0, 1}}}};
  drop_zero_coordinates(space);
  EXPECT_EQ(names_of(space), "x,y,z");
}

TEST(PointFile, ThatIsNoFileIsRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal(folder / "a.csv"), "a.csv: there is no such file");
  fs::create_directory(folder / "b.csv");
  EXPECT_EQ(refusal(folder / "b.csv"), "b.csv: this is a folder, not a file");
}

TEST(PointFile, OfAnotherEndingIsRefused) {
  const TemporaryFolder folder;
  for (const char* name : {"a.txt", "a", "a.csv.gz", ".csv"})
    EXPECT_EQ(refusal(write(folder / name, "x\n1\n")),
              std::string(name) +
                  ": a file of points must end in .csv, .vtp, .vtu, .vtk, .hdf, .h5, .hdf5");
}

TEST(PointFile, ThatMustNotBeReadIsRefused) {
  if (geteuid() == 0) GTEST_SKIP() << "root reads everything";
  const TemporaryFolder folder;
  for (const char* name : {"a.csv", "a.hdf", "a.vtp"}) {
    fs::permissions(write(folder / name, "x\n1\n"), fs::perms::none);
    EXPECT_EQ(refusal(folder / name), std::string(name) + ": cannot read this file");
  }
}

}  // namespace
}  // namespace mote::test
