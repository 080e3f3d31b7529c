#include "mote/output/snapshot.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

#include "mote/output/hdf5.hpp"
#include "mote/output/tables.hpp"
#include "mote/particles/failure.hpp"
#include "support/program.hpp"

namespace mote {
namespace {

/// Three particles in `dimension` dimensions, every number another one.
Cloud cloud_in(int dimension) {
  Cloud cloud(dimension, 3);
  cloud.add("velocity", FieldKind::vector, "m/s");
  cloud.add("density", FieldKind::scalar, "kg/m3");
  cloud.add("nothing", FieldKind::scalar, "");
  double next = 1.0 / 3;
  for (const Field& field : cloud.fields())
    for (double& value : cloud.values(field.name)) value = next += 1.0 / 7;
  return cloud;
}

void expect_equal(const Cloud& a, const Cloud& b) {
  ASSERT_EQ(a.fields().size(), b.fields().size());
  for (std::size_t f = 0; f < a.fields().size(); ++f) {
    EXPECT_EQ(a.fields()[f].name, b.fields()[f].name);
    EXPECT_EQ(a.fields()[f].kind, b.fields()[f].kind);
    EXPECT_EQ(a.fields()[f].si_unit, b.fields()[f].si_unit);
    EXPECT_EQ(a.fields()[f].values, b.fields()[f].values);
  }
}

class Snapshots : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, Snapshots, testing::Values(1, 2, 3));

TEST_P(Snapshots, ReadBackWhatWasWritten) {
  const test::TemporaryFolder folder;
  const Cloud cloud = cloud_in(GetParam());
  write_snapshot(folder / "a.hdf", {4, 50, 0.1}, "me", cloud);
  const Snapshot read = read_snapshot(folder / "a.hdf");
  EXPECT_EQ(read.moment.frame, 4);
  EXPECT_EQ(read.moment.step, 50);
  EXPECT_EQ(read.moment.time, 0.1);
  EXPECT_EQ(read.fingerprint, "me");
  expect_equal(read.cloud, cloud);
  EXPECT_FALSE(test::fs::exists(folder / "a.hdf.part"));
}

TEST_P(Snapshots, OfEqualStatesHaveEqualBytes) {
  const test::TemporaryFolder folder;
  Cloud cloud = cloud_in(GetParam());
  write_snapshot(folder / "a.hdf", {4, 50, 0.1}, "me", cloud);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // times in files are in seconds
  write_snapshot(folder / "b.hdf", {4, 50, 0.1}, "me", cloud);
  EXPECT_EQ(test::read(folder / "a.hdf"), test::read(folder / "b.hdf"));
  cloud.values("density")[1] *= 1 + 1e-15;
  write_snapshot(folder / "c.hdf", {4, 50, 0.1}, "me", cloud);
  EXPECT_NE(test::read(folder / "a.hdf"), test::read(folder / "c.hdf"));
}

TEST(Snapshot, ThatIsCutShortIsRefused) {
  const test::TemporaryFolder folder;
  write_snapshot(folder / "a.hdf", {}, "me", cloud_in(2));
  test::fs::resize_file(folder / "a.hdf", 3000);
  EXPECT_THROW(read_snapshot(folder / "a.hdf"), InputError);
}

/// Three particles that have changed places.
Cloud sorted_cloud() {
  Cloud cloud = cloud_in(2);
  std::ranges::copy(std::array{7.0, 2.0, 5.0}, cloud.add("id", FieldKind::scalar, "").begin());
  std::ranges::copy(std::array{0.7, 0.2, 0.5}, cloud.values("density").begin());
  return cloud;
}

TEST(Snapshot, HoldsTheIdsOfParticlesOnce) {
  const test::TemporaryFolder folder;
  const Cloud cloud = sorted_cloud();
  write_snapshot(folder / "a.hdf", {4, 50, 0.1}, "me", cloud);
  expect_equal(read_snapshot(folder / "a.hdf").cloud, cloud);
  const hdf5::Handle file = hdf5::open_file((folder / "a.hdf").string());
  const hdf5::Handle data = hdf5::open_group(file, "VTKHDF/PointData");
  EXPECT_EQ(hdf5::read_doubles(data, "id"), (std::vector<double>{7, 2, 5}));
}

TEST(Snapshot, NamesBodiesAndSpacing) {
  const test::TemporaryFolder folder;
  const std::vector<Body> bodies{{.name = "water"}, {.name = "tank", .kind = BodyKind::wall}};
  write_snapshot(folder / "a.hdf", {4, 50, 0.1}, "me", sorted_cloud(), {0.25, bodies});
  const hdf5::Handle file = hdf5::open_file((folder / "a.hdf").string());
  const hdf5::Handle group = hdf5::open_group(file, "mote");
  EXPECT_EQ(hdf5::read_double(group, "spacing"), 0.25);
  EXPECT_EQ(hdf5::read_string(group, "body_names"), "water\ntank\n");
  EXPECT_EQ(hdf5::read_string(group, "body_kinds"), "fluid\nwall\n");
}

TEST(Csv, HasRowsInOrderOfIds) {
  const std::string text = csv_of(sorted_cloud());
  EXPECT_THAT(text, testing::StartsWith("id,x,y,velocity_x,velocity_y,density,nothing\n2,"));
  const auto five = text.find("\n5,"), seven = text.find("\n7,");
  EXPECT_LT(five, seven);
  EXPECT_LT(seven, text.size());
  EXPECT_THAT(text.substr(five, seven - five), testing::HasSubstr(",0.5,"));
}

TEST(Csv, NamesComponentsByAxis) {
  const std::string text = csv_of(cloud_in(2));
  EXPECT_THAT(text,
              testing::StartsWith("id,x,y,velocity_x,velocity_y,density,nothing\n0,0.4761904"));
}

}  // namespace
}  // namespace mote
