#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "mote/output/files.hpp"
#include "mote/output/particle_ids.hpp"
#include "mote/output/tables.hpp"

namespace mote {
namespace {

/// A field as VTK wants it: vectors and positions with three components.
vtkSmartPointer<vtkDoubleArray> array_of(const Field& field, const std::vector<Index>& order) {
  const auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(field.name.c_str());
  array->SetNumberOfComponents(field.kind == FieldKind::vector ? 3 : 1);
  array->SetNumberOfTuples(static_cast<vtkIdType>(order.size()));
  array->Fill(0);
  for (std::size_t row = 0; row < order.size(); ++row)
    for (int c = 0; c < field.components; ++c)
      array->SetComponent(
          static_cast<vtkIdType>(row), c,
          field.values[static_cast<std::size_t>(order[row]) * field.components + c]);
  return array;
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const Cloud& cloud) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIdTypeArray> id;
  id->SetName("id");
  const std::vector<Index> order = in_order_of_ids(cloud);
  for (vtkIdType i = 0; i < cloud.count(); ++i) {
    vertices->InsertNextCell(1, &i);
    id->InsertNextValue(id_of(cloud, order[i]));
  }
  points->SetData(array_of(cloud.fields().front(), order));
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(id);
  for (const Field& field : cloud.fields())
    if (field.name != "position" && field.name != id_field)
      data->GetPointData()->AddArray(array_of(field, order));

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToBinary();  // inline: ParaView 5.11 cannot read appended data
  writer->WriteToOutputStringOn();
  writer->Write();
  write_file(path, writer->GetOutputString());
}

}  // namespace mote
