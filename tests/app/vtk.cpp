#include <gmock/gmock.h>
#include <vtkDataArray.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>

#include <nlohmann/json.hpp>

#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

/// Compares a data set with the CSV columns id,x,velocity_x,density.
void expect_csv(vtkPointSet* points, const std::vector<std::vector<double>>& rows) {
  ASSERT_EQ(points->GetNumberOfPoints(), static_cast<vtkIdType>(rows.size()));
  vtkPointData* data = points->GetPointData();
  for (const char* name : {"id", "velocity", "density", "mass", "length"})
    ASSERT_NE(data->GetArray(name), nullptr) << name;
  EXPECT_EQ(data->GetArray("velocity")->GetNumberOfComponents(), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto point = static_cast<vtkIdType>(i);
    EXPECT_EQ(data->GetArray("id")->GetComponent(point, 0), rows[i][0]);
    EXPECT_EQ(points->GetPoint(point)[0], rows[i][1]);
    EXPECT_EQ(points->GetPoint(point)[1], 0);
    EXPECT_EQ(data->GetArray("velocity")->GetComponent(point, 0), rows[i][2]);
    EXPECT_EQ(data->GetArray("density")->GetComponent(point, 0), rows[i][3]);
  }
}

class Vtk : public testing::Test {
 protected:
  Vtk() {
    mote(run_arguments("gravity/slab.yaml", folder_ / "out"));
    mote({"export", out().string(), "--to", (folder_ / "last.csv").string()});
    rows_ = rows_of(read(folder_ / "last.csv"));
  }
  fs::path out() const { return folder_ / "out"; }

  TemporaryFolder folder_;
  std::vector<std::vector<double>> rows_;
};

TEST_F(Vtk, ReadsASnapshot) {
  vtkNew<vtkHDFReader> reader;
  const std::string file = (out() / "snapshots/000010.hdf").string();
  ASSERT_TRUE(reader->CanReadFile(file.c_str()));
  reader->SetFileName(file.c_str());
  reader->Update();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0));
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(grid->GetNumberOfCells(), 1);
  expect_csv(grid, rows_);
}

TEST_F(Vtk, ReadsAnExportedVtp) {
  const std::string file = (folder_ / "last.vtp").string();
  EXPECT_EQ(mote({"export", out().string(), "--to", file}).exit_code, 0);
  const std::string text = read(file);
  EXPECT_EQ(text.find("<AppendedData"), std::string::npos) << "ParaView 5.11 needs inline data";
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfVerts(), 41);
  expect_csv(reader->GetOutput(), rows_);
}

TEST_F(Vtk, SeriesNamesEverySnapshotWithItsTime) {
  const auto series = nlohmann::json::parse(read(out() / "snapshots.hdf.series"));
  EXPECT_EQ(series["file-series-version"], "1.0");
  ASSERT_EQ(series["files"].size(), 11);
  for (std::size_t k = 0; k < 11; ++k) {
    EXPECT_DOUBLE_EQ(series["files"][k]["time"].get<double>(), 0.75 * static_cast<double>(k));
    EXPECT_TRUE(fs::exists(out() / series["files"][k]["name"].get<std::string>()));
  }
}

}  // namespace
}  // namespace mote::test
