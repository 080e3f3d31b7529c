#include <vtkDataArray.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkStringOutputWindow.h>
#include <vtkXMLGenericDataObjectReader.h>

#include "mote/input/point_table.hpp"

namespace mote {
namespace {

/// Catches what VTK prints. Its readers go on with half the numbers of a damaged file, and nothing
/// but these messages tells.
class Messages {
 public:
  Messages()
      : window_before_(vtkOutputWindow::GetInstance()),
        display_before_(vtkObject::GetGlobalWarningDisplay()),
        verbosity_before_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkOutputWindow::SetInstance(window_);
    vtkObject::GlobalWarningDisplayOn();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~Messages() {
    vtkOutputWindow::SetInstance(window_before_);
    vtkObject::SetGlobalWarningDisplay(display_before_);
    vtkLogger::SetStderrVerbosity(verbosity_before_);
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  bool empty() const { return window_->GetOutput().empty(); }

 private:
  vtkNew<vtkStringOutputWindow> window_;
  vtkSmartPointer<vtkOutputWindow> window_before_;
  int display_before_;
  vtkLogger::Verbosity verbosity_before_;
};

template <class Reader>
vtkSmartPointer<vtkDataObject> output_of(const std::filesystem::path& path) {
  const Messages messages;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!messages.empty())
    throw InputError(
        "VTK cannot read this file; it is damaged, not what its ending says, or has numbers that "
        "are not finite");
  return reader->GetOutput();
}

void append(PointTable& table, const std::string& name, const std::vector<std::string>& columns,
            vtkDataArray& array) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(array.GetNumberOfValues()));
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
    for (int c = 0; c < array.GetNumberOfComponents(); ++c)
      values.push_back(array.GetComponent(i, c));
  append(table, name, columns, values);
}

PointTable table_of(vtkPointSet& points) {
  PointTable table;
  if (points.GetNumberOfPoints() == 0) throw InputError("there are no points");
  append(table, "Points", coordinate_names("Points", 3), *points.GetPoints()->GetData());
  drop_zero_coordinates(table);
  vtkPointData& data = *points.GetPointData();
  for (int k = 0; k < data.GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = data.GetArray(k))
      append(table, array->GetName(),
             component_names(array->GetName(),
                             static_cast<std::size_t>(array->GetNumberOfComponents())),
             *array);
  return table;
}

}  // namespace

PointTable read_vtk_points(const std::filesystem::path& path) {
  return at_place(path.string(), [&] {
    const auto data = path.extension() == ".vtk" ? output_of<vtkGenericDataObjectReader>(path)
                                                 : output_of<vtkXMLGenericDataObjectReader>(path);
    vtkPointSet* points = vtkPointSet::SafeDownCast(data);
    if (points == nullptr) throw InputError("this VTK file holds no set of points");
    PointTable table = table_of(*points);
    check_numbers(table);
    return table;
  });
}

}  // namespace mote
