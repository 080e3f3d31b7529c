#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "mote/output/files.hpp"
#include "mote/output/tables.hpp"

namespace mote {
namespace {

/// A field as VTK wants it: vectors and positions with three components.
vtkSmartPointer<vtkDoubleArray> array_of(const Field& field, Index count) {
  const auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(field.name.c_str());
  array->SetNumberOfComponents(field.kind == FieldKind::vector ? 3 : 1);
  array->SetNumberOfTuples(count);
  array->Fill(0);
  for (Index i = 0; i < count; ++i)
    for (int c = 0; c < field.components; ++c)
      array->SetComponent(i, c, field.values[static_cast<std::size_t>(i) * field.components + c]);
  return array;
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const Cloud& cloud) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIdTypeArray> id;
  id->SetName("id");
  for (vtkIdType i = 0; i < cloud.count(); ++i) {
    vertices->InsertNextCell(1, &i);
    id->InsertNextValue(i);
  }
  points->SetData(array_of(cloud.fields().front(), cloud.count()));
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(id);
  for (const Field& field : cloud.fields())
    if (field.name != "position") data->GetPointData()->AddArray(array_of(field, cloud.count()));

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToBinary();  // inline: ParaView 5.11 cannot read appended data
  writer->WriteToOutputStringOn();
  writer->Write();
  write_file(path, writer->GetOutputString());
}

}  // namespace mote
