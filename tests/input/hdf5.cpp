#include "mote/output/hdf5.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "input/refusal.hpp"
#include "mote/output/snapshot.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void write_numbers(hid_t group, const std::string& name, const std::vector<double>& values,
                   hsize_t columns = 0) {
  const hsize_t rows = columns == 0 ? values.size() : values.size() / columns;
  hdf5::write(group, name, H5T_NATIVE_DOUBLE, values.data(), rows, columns);
}

/// A group of VTKHDF with these points.
hdf5::Handle write_vtk(hid_t file, const std::vector<double>& points) {
  hdf5::Handle vtk = hdf5::create_group(file, "VTKHDF");
  write_numbers(vtk, "Points", points, 3);
  return vtk;
}

class Hdf5Points : public testing::Test {
 protected:
  Hdf5Points() { hdf5::be_quiet(); }

  /// The file that `fill` wrote into.
  template <class Fill>
  fs::path file_of(Fill fill) const {
    fill(hdf5::create_file(path_.string()));
    return path_;
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "a.hdf";
};

class SnapshotsAsPoints : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, SnapshotsAsPoints, testing::Values(1, 2, 3));

TEST_P(SnapshotsAsPoints, HaveTheirDimensionAndEveryBit) {
  const TemporaryFolder folder;
  const int dimension = GetParam();
  Cloud cloud(dimension, 2);
  cloud.add("velocity", FieldKind::vector, "m/s");
  cloud.add("density", FieldKind::scalar, "kg/m3");
  double next = 1.0 / 3;
  for (const Field& field : cloud.fields())
    for (double& value : cloud.values(field.name)) value = next += 1.0 / 7;
  write_snapshot(folder / "a.hdf", {4, 50, 0.1}, "me", cloud);

  const PointTable table = read_points(folder / "a.hdf");
  EXPECT_EQ(names_of(table), std::string("x,y,z").substr(0, 2 * dimension - 1) +
                                 ",id,velocity_x,velocity_y,velocity_z,density");
  EXPECT_THAT(table.column("id"), ElementsAre(0, 1));
  EXPECT_THAT(table.column("density"), testing::ElementsAreArray(cloud.values("density")));
  for (int c = 0; c < dimension; ++c)
    for (int i = 0; i < 2; ++i) {
      const std::string axis(1, "xyz"[c]);
      EXPECT_EQ(table.column(axis)[i], cloud.values("position")[i * dimension + c]);
      EXPECT_EQ(table.column("velocity_" + axis)[i], cloud.values("velocity")[i * dimension + c]);
    }
}

TEST_F(Hdf5Points, OfVtkNeedNoPointData) {
  const PointTable table = read_points(file_of([](hid_t file) {
    write_vtk(file, {1, 2, 0, 3, 4, 0});
  }));
  EXPECT_EQ(names_of(table), "x,y");
  EXPECT_THAT(table.column("y"), ElementsAre(2, 4));
}

TEST_F(Hdf5Points, OfVtkMayBeInAGroupThatKeepsNoOrder) {
  const PointTable table = read_points(file_of([](hid_t file) {
    const hdf5::Handle vtk = write_vtk(file, {1, 0, 0});
    const hdf5::Handle data(H5Gcreate2(vtk, "PointData", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                            H5Gclose, "group");
    write_numbers(data, "b", {1});
    write_numbers(data, "a", {1, 2, 3, 4}, 4);
  }));
  EXPECT_EQ(names_of(table), "x,a_0,a_1,a_2,a_3,b");
}

TEST_F(Hdf5Points, MayBePlainDataSets) {
  const PointTable table = read_points(file_of([](hid_t file) {
    const std::vector<std::int32_t> whole{7, 8};
    hdf5::write(file, "level", H5T_NATIVE_INT32, whole.data(), 2);
    write_numbers(file, "y", {0, 0});
    write_numbers(file, "x", {1, 2});
    write_numbers(file, "velocity", {1, 2, 3, 4}, 2);
    write_numbers(file, "mass", {5, 6}, 1);
    const hdf5::Handle group = hdf5::create_group(file, "remarks");
    write_numbers(group, "of another length", {1});
  }));
  EXPECT_EQ(names_of(table), "x,y,level,mass,velocity_x,velocity_y");
  EXPECT_THAT(table.column("y"), ElementsAre(0, 0));
  EXPECT_THAT(table.column("level"), ElementsAre(7, 8));
  EXPECT_THAT(table.column("velocity_y"), ElementsAre(2, 4));
}

TEST_F(Hdf5Points, MayHaveADataSetPosition) {
  for (hsize_t dimension : {0, 1, 2, 3}) {
    const fs::path path = file_of([&](hid_t file) {
      write_numbers(file, "a", {1, 2});
      write_numbers(file, "position", std::vector<double>(2 * std::max<hsize_t>(1, dimension), 1),
                    dimension);
    });
    const char* names[] = {"x,a", "x,a", "x,y,a", "x,y,z,a"};
    EXPECT_EQ(names_of(read_points(path)), names[dimension]);
  }
}

TEST_F(Hdf5Points, LeaveOutTexts) {
  EXPECT_EQ(names_of(read_points(file_of([](hid_t file) {
              write_numbers(file, "x", {1});
              const hdf5::Handle space(H5Screate(H5S_SCALAR), H5Sclose, "space");
              const hdf5::Handle text(H5Dcreate2(file, "remark", H5T_C_S1, space, H5P_DEFAULT,
                                                 H5P_DEFAULT, H5P_DEFAULT),
                                      H5Dclose, "text");
            }))),
            "x");
}

TEST_F(Hdf5Points, OfDifferentLengthsAreRefused) {
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "mass", {1, 2, 3});
              write_numbers(file, "x", {1, 2});
            })),
            "a.hdf: 'mass' has length 3, but x has length 2");
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "x", {1, 2});
              write_numbers(file, "y", {1});
            })),
            "a.hdf: 'y' has length 1, but x has length 2");
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              const hdf5::Handle vtk = write_vtk(file, {1, 2, 3});
              write_numbers(hdf5::create_group(vtk, "PointData"), "v", {1, 2, 3, 4}, 2);
            })),
            "a.hdf: 'v' has length 2, but x has length 1");
}

TEST_F(Hdf5Points, WithASingleNumberBesideAreRefused) {
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "x", {1, 2});
              const hdf5::Handle space(H5Screate(H5S_SCALAR), H5Sclose, "space");
              const hdf5::Handle time(H5Dcreate2(file, "time", H5T_NATIVE_DOUBLE, space,
                                                 H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                      H5Dclose, "time");
            })),
            "a.hdf: 'time' has length 1, but x has length 2");
}

TEST_F(Hdf5Points, WithoutPositionsAreRefused) {
  constexpr auto neither =
      "a.hdf: there is neither a group VTKHDF nor, at the root, a data set x (N) or position "
      "(N x D)";
  EXPECT_EQ(refusal(file_of([](hid_t) {})), neither);
  EXPECT_EQ(refusal(file_of([](hid_t file) { write_numbers(file, "X", {1}); })), neither);
  EXPECT_EQ(refusal(file_of([](hid_t file) { write_numbers(file, "x", {1, 2}, 2); })), neither);
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "x", {1});
              write_numbers(file, "z", {1});
            })),
            "a.hdf: there is a column z, but no column y");
  EXPECT_EQ(refusal(file_of([](hid_t file) { hdf5::create_group(file, "VTKHDF"); })),
            "a.hdf: there is no Points");
}

TEST_F(Hdf5Points, OfOddShapesAreRefused) {
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "position", {1, 2, 3, 4}, 4);
            })),
            "a.hdf: 'position' has 4 numbers a point; a position has 1 to 3");
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "x", {1});
              write_numbers(file, "position", {1, 2}, 2);
            })),
            "a.hdf: the column 'x' is there twice");
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "x", {1});
              const hsize_t lengths[] = {1, 3, 3};
              const hdf5::Handle space(H5Screate_simple(3, lengths, nullptr), H5Sclose, "space");
              const hdf5::Handle stress(H5Dcreate2(file, "stress", H5T_NATIVE_DOUBLE, space,
                                                   H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                        H5Dclose, "stress");
            })),
            "a.hdf: 'stress' has 3 dimensions; points and components make two");
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              hdf5::create_group(hdf5::create_group(file, "VTKHDF"), "Points");
            })),
            "a.hdf: 'Points' is no data set of numbers");
}

TEST_F(Hdf5Points, WithoutPointsAreRefused) {
  EXPECT_EQ(refusal(file_of([](hid_t file) { write_numbers(file, "x", {}); })),
            "a.hdf: there are no points");
  EXPECT_EQ(refusal(file_of([](hid_t file) { write_vtk(file, {}); })),
            "a.hdf: there are no points");
}

TEST_F(Hdf5Points, ThatAreNotFiniteAreRefused) {
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "x", {1, nan});
            })),
            "a.hdf: x of point 1 is not a number");
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_vtk(file, {1, 0, 0, 1, 0, std::numeric_limits<double>::infinity()});
            })),
            "a.hdf: z of point 1 is infinite");
  EXPECT_EQ(refusal(file_of([](hid_t file) {
              write_numbers(file, "x", {1});
              write_numbers(file, "v", {1, nan}, 2);
            })),
            "a.hdf: v_y of point 0 is not a number");
}

/// A file of VTK with so many steps of time, and one point in each.
void write_steps(hid_t file, std::int64_t steps) {
  const hdf5::Handle vtk =
      write_vtk(file, std::vector<double>(3 * static_cast<std::size_t>(steps), 1));
  hdf5::write_attribute(hdf5::create_group(vtk, "Steps"), "NSteps", std::span(&steps, 1));
}

TEST_F(Hdf5Points, OfSeveralTimesAreRefused) {
  EXPECT_EQ(refusal(file_of([](hid_t file) { write_steps(file, 2); })),
            "a.hdf: this file holds several times; a file of points holds one");
  EXPECT_EQ(read_points(file_of([](hid_t file) { write_steps(file, 1); })).rows(), 1u);
}

TEST_F(Hdf5Points, InADamagedFileAreRefused) {
  for (const char* name : {"a.hdf", "a.h5", "a.hdf5"})
    EXPECT_EQ(refusal(write(folder_ / name, "x\n1\n")),
              std::string(name) + ": this is not a whole HDF5 file");
  file_of([](hid_t file) { write_numbers(file, "x", std::vector<double>(1000, 1)); });
  fs::resize_file(path_, 3000);
  EXPECT_EQ(refusal(path_), "a.hdf: this is not a whole HDF5 file");
}

}  // namespace
}  // namespace mote::test
