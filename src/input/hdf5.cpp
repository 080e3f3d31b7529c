#include "mote/output/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mote/input/point_table.hpp"

namespace mote {
namespace {

using Shape = std::vector<hsize_t>;
using Names = std::vector<std::string> (*)(const std::string&, std::size_t);

void append(PointTable& table, hid_t group, const std::string& name, const Shape& shape,
            Names names) {
  if (shape.size() > 2)
    throw InputError(
        fmt::format("'{}' has {} dimensions; points and components make two", name, shape.size()));
  append(table, name, names(name, shape.size() == 2 ? shape[1] : 1),
         hdf5::read_doubles(group, name));
}

/// Appends the data set if it is one of numbers.
void append_if_numbers(PointTable& table, hid_t group, const std::string& name, Names names) {
  if (const auto shape = hdf5::shape_of_numbers(group, name))
    append(table, group, name, *shape, names);
}

PointTable points_of_vtk(hid_t vtk) {
  if (hdf5::has(vtk, "Steps") && hdf5::read_integer(hdf5::open_group(vtk, "Steps"), "NSteps") > 1)
    throw InputError("this file holds several times; a file of points holds one");
  PointTable table;
  const auto shape = hdf5::shape_of_numbers(vtk, "Points");
  if (!shape) throw InputError("'Points' is no data set of numbers");
  append(table, vtk, "Points", *shape, coordinate_names);
  drop_zero_coordinates(table);
  if (!hdf5::has(vtk, "PointData")) return table;
  const hdf5::Handle data = hdf5::open_group(vtk, "PointData");
  for (const std::string& name : hdf5::members(data))
    append_if_numbers(table, data, name, component_names);
  return table;
}

bool is_position(const std::string& name) {
  return name == "position" || name == "x" || name == "y" || name == "z";
}

PointTable points_at_root(hid_t root) {
  PointTable table;
  std::vector<std::string> names = hdf5::members(root);
  std::ranges::stable_partition(names, is_position);  // they say how long the others must be
  for (const std::string& name : names)
    append_if_numbers(table, root, name, name == "position" ? coordinate_names : component_names);
  if (!table.has("x"))
    throw InputError(
        "there is neither a group VTKHDF nor, at the root, a data set x (N) or position (N x D)");
  return table;
}

}  // namespace

PointTable read_hdf5_points(const std::filesystem::path& path) {
  hdf5::be_quiet();
  return at_place(path.string(), [&] {
    const hdf5::Handle file = hdf5::open_file(path.string());
    PointTable table = hdf5::has(file, "VTKHDF") ? points_of_vtk(hdf5::open_group(file, "VTKHDF"))
                                                 : points_at_root(hdf5::open_group(file, "/"));
    check_coordinates(table);
    check_numbers(table);
    return table;
  });
}

}  // namespace mote
