#include <gmock/gmock.h>

#include <limits>

#include "input/refusal.hpp"
#include "mote/output/tables.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;

constexpr auto unreadable =
    ": VTK cannot read this file; it is damaged, not what its ending says, or has numbers that are "
    "not finite";

constexpr auto point_data = R"(<PointData>
<DataArray type="Float64" Name="mass" format="ascii">5 6</DataArray>
<DataArray type="Int32" Name="velocity" NumberOfComponents="3" format="ascii">1 2 3 4 5 6</DataArray>
<DataArray type="Float32" Name="pair" NumberOfComponents="2" format="ascii">1 2 3 4</DataArray>
<DataArray type="Float64" Name="t" NumberOfComponents="4" format="ascii">1 2 3 4 5 6 7 8</DataArray>
<Array type="String" Name="remark" format="ascii">65 0 66 0</Array>
</PointData>)";

std::string points_of(const std::string& positions) {
  return R"(<Points><DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">)" +
         positions + "</DataArray></Points>\n";
}

/// A file of two points.
std::string vtp(const std::string& positions, const std::string& data = point_data) {
  return R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="2" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
)" + data +
         points_of(positions) + "</Piece></PolyData></VTKFile>\n";
}

std::string vtu(const std::string& positions) {
  return R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="2" NumberOfCells="0">
)" + std::string(point_data) +
         points_of(positions) + R"(<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii"></DataArray>
<DataArray type="Int64" Name="offsets" format="ascii"></DataArray>
<DataArray type="UInt8" Name="types" format="ascii"></DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>
)";
}

std::string vtk(const std::string& positions) {
  return R"(# vtk DataFile Version 3.0
two points
ASCII
DATASET POLYDATA
POINTS 2 double
)" + positions +
         R"(
POINT_DATA 2
SCALARS mass double 1
LOOKUP_TABLE default
5 6
VECTORS velocity float
1 2 3 4 5 6
FIELD more 2
pair 2 2 float
1 2 3 4
t 4 2 double
1 2 3 4 5 6 7 8
)";
}

class VtkPoints : public testing::Test {
 protected:
  fs::path file(const std::string& name, const std::string& text) const {
    return write(folder_ / name, text);
  }
  /// What a file is refused for, with nothing said on the terminal.
  std::string refused(const std::string& name, const std::string& text) const {
    testing::internal::CaptureStderr();
    const std::string message = refusal(file(name, text));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    return message;
  }

  TemporaryFolder folder_;
};

TEST_F(VtkPoints, AreReadFromAllKindsOfFiles) {
  for (const fs::path& path : {file("a.vtp", vtp("1 2 3 4 5 6")), file("a.vtu", vtu("1 2 3 4 5 6")),
                               file("a.vtk", vtk("1 2 3 4 5 6"))}) {
    SCOPED_TRACE(path.extension());
    const PointTable table = read_points(path);
    EXPECT_EQ(names_of(table),
              "x,y,z,mass,velocity_x,velocity_y,velocity_z,pair_x,pair_y,t_0,t_1,t_2,t_3");
    EXPECT_THAT(table.column("x"), ElementsAre(1, 4));
    EXPECT_THAT(table.column("z"), ElementsAre(3, 6));
    EXPECT_THAT(table.column("mass"), ElementsAre(5, 6));
    EXPECT_THAT(table.column("velocity_y"), ElementsAre(2, 5));
    EXPECT_THAT(table.column("pair_y"), ElementsAre(2, 4));
    EXPECT_THAT(table.column("t_3"), ElementsAre(4, 8));
  }
}

TEST_F(VtkPoints, LoseTheCoordinatesThatVtkAdded) {
  const auto names = [&](const char* positions) {
    return names_of(read_points(file("a.vtp", vtp(positions, ""))));
  };
  EXPECT_EQ(names("1 2 0 3 4 0"), "x,y");
  EXPECT_EQ(names("1 0 0 3 0 0"), "x");
  EXPECT_EQ(names("1 0 0 3 0 1"), "x,y,z");
  EXPECT_EQ(names_of(read_points(file("a.vtk", vtk("1 0 0 3 0 0")))).substr(0, 6), "x,mass");
}

Cloud two_particles() {
  Cloud cloud(2, 2);
  cloud.add("velocity", FieldKind::vector, "m/s");
  cloud.add("density", FieldKind::scalar, "kg/m3");
  double next = 1.0 / 3;
  for (const Field& field : cloud.fields())
    for (double& value : cloud.values(field.name)) value = next += 1.0 / 7;
  return cloud;
}

TEST_F(VtkPoints, KeepEveryBitThatMoteWrites) {
  const Cloud cloud = two_particles();
  write_vtp(folder_ / "a.vtp", cloud);
  const PointTable table = read_points(folder_ / "a.vtp");
  EXPECT_EQ(names_of(table), "x,y,id,velocity_x,velocity_y,velocity_z,density");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(table.column("y")[i], cloud.values("position")[2 * i + 1]);
    EXPECT_EQ(table.column("velocity_x")[i], cloud.values("velocity")[2 * i]);
  }
}

TEST_F(VtkPoints, ThatAreNotFiniteAreRefused) {
  Cloud cloud = two_particles();
  cloud.values("density")[1] = std::numeric_limits<double>::infinity();
  write_vtp(folder_ / "a.vtp", cloud);
  EXPECT_EQ(refusal(folder_ / "a.vtp"), "a.vtp: density of point 1 is infinite");
  cloud.values("position")[2] = std::numeric_limits<double>::quiet_NaN();
  write_vtp(folder_ / "a.vtp", cloud);
  EXPECT_EQ(refusal(folder_ / "a.vtp"), "a.vtp: x of point 1 is not a number");
}

/// Not all of VTK's readers know a text for them, and a file holds the length of an infinite vector
/// as text.
TEST_F(VtkPoints, ThatAreNotFiniteInTextAreRefused) {
  EXPECT_EQ(refused("a.vtk", vtk("1 2 3 4 nan 6")), std::string("a.vtk") + unreadable);
  Cloud cloud = two_particles();
  cloud.values("velocity")[0] = std::numeric_limits<double>::infinity();
  write_vtp(folder_ / "a.vtp", cloud);
  EXPECT_EQ(refusal(folder_ / "a.vtp"), std::string("a.vtp") + unreadable);
}

TEST_F(VtkPoints, WithAFieldCalledXAreRefused) {
  EXPECT_EQ(refused("a.vtp", vtp("1 2 3 4 5 6",
                                 R"(<PointData><DataArray type="Float64" Name="x" format="ascii">
                                    1 2</DataArray></PointData>)")),
            "a.vtp: the column 'x' is there twice");
}

TEST_F(VtkPoints, ThatAreNoneAreRefused) {
  write_vtp(folder_ / "a.vtp", Cloud(1, 0));
  EXPECT_EQ(refusal(folder_ / "a.vtp"), "a.vtp: there are no points");
  constexpr auto image =
      "# vtk DataFile Version 3.0\nan image\nASCII\nDATASET STRUCTURED_POINTS\n"
      "DIMENSIONS 2 1 1\nORIGIN 0 0 0\nSPACING 1 1 1\n";
  EXPECT_EQ(refused("a.vtk", image), "a.vtk: this VTK file holds no set of points");
}

TEST_F(VtkPoints, InADamagedXmlFileAreRefused) {
  const std::string whole = vtp("1 2 3 4 5 6");
  for (const std::string& text : {std::string(), std::string("x\n1\n"), vtk("1 2 3 4 5 6"),
                                  whole.substr(0, 600), vtp("1 2 3 4"), vtp("1 2 3 4 five 6")})
    for (const char* name : {"a.vtp", "a.vtu"})
      EXPECT_EQ(refused(name, text), std::string(name) + unreadable) << text;
}

/// VTK's reader takes these for whole, and only says something.
TEST_F(VtkPoints, InADamagedLegacyFileAreRefused) {
  const std::string whole = vtk("1 2 3 4 5 6");
  for (const std::string& text :
       {std::string(), std::string("x\n1\n"), vtp("1 2 3 4 5 6"), whole.substr(0, 200),
        whole.substr(0, whole.size() - 5), vtk("1 2 3 4"), vtk("1 2 3 4 five 6")})
    EXPECT_EQ(refused("a.vtk", text), std::string("a.vtk") + unreadable) << text;
}

TEST_F(VtkPoints, AreReadAfterADamagedFile) {
  refused("a.vtp", "");
  EXPECT_EQ(read_points(file("b.vtp", vtp("1 2 3 4 5 6"))).rows(), 2u);
}

}  // namespace
}  // namespace mote::test
