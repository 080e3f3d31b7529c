#include <fmt/format.h>

#include <iterator>

#include "mote/output/particle_ids.hpp"
#include "mote/output/tables.hpp"

namespace mote {
namespace {

std::string header(const Cloud& cloud) {
  std::string line = "id";
  for (const Field& field : cloud.fields())
    for (int c = 0; field.name != id_field && c < field.components; ++c) {
      line += ',';
      if (field.name != "position") line += field.name;
      if (field.kind == FieldKind::vector && field.name != "position") line += '_';
      if (field.kind == FieldKind::vector) line += axis_names[c];
    }
  return line + '\n';
}

}  // namespace

std::string csv_of(const Cloud& cloud) {
  std::string text = header(cloud);
  for (const Index i : in_order_of_ids(cloud)) {
    fmt::format_to(std::back_inserter(text), "{}", id_of(cloud, i));
    for (const Field& field : cloud.fields())
      for (int c = 0; field.name != id_field && c < field.components; ++c)
        fmt::format_to(std::back_inserter(text), ",{:.17g}",
                       field.values[static_cast<std::size_t>(i) * field.components + c]);
    text += '\n';
  }
  return text;
}

std::string csv_of(const Table& table) {
  std::string text;
  for (const Column& column : table) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (std::size_t row = 0; !table.empty() && row < table[0].values.size(); ++row) {
    for (std::size_t c = 0; c < table.size(); ++c)
      fmt::format_to(std::back_inserter(text), "{}{:.17g}", c > 0 ? "," : "", table[c].values[row]);
    text += '\n';
  }
  return text;
}

}  // namespace mote
