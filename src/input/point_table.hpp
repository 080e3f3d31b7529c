#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mote/particles/failure.hpp"

namespace mote {

/// Anybody's points: columns of numbers by name, all of one length. Positions are the columns x, y
/// and z; a vector field `velocity` is the columns velocity_x, velocity_y, ...
struct PointTable {
  std::vector<std::pair<std::string, std::vector<double>>> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().second.size(); }
  bool has(const std::string& name) const;
  /// Throws InputError if there is no such column.
  std::span<const double> column(const std::string& name) const;
};

/// Reads a file of points by its ending: .csv; .vtp, .vtu or .vtk, if built with VTK; .hdf, .h5 or
/// .hdf5, be it VTKHDF (mote's snapshots are) or plain data sets at the root of the file. Throws
/// InputError, `FILE:LINE:COLUMN: ...` for .csv and `FILE: ...` for the others, for a file that is
/// not there, not such a file, has no column x, no rows, columns of different lengths, or a number
/// that is not finite. Messages number the points from 0.
PointTable read_points(const std::filesystem::path& path);

/// One header row of column names, then a row of numbers for every point. Lines that start with #
/// and blank lines at the end are no rows; any other line has a cell for every column.
PointTable read_csv_points(const std::filesystem::path& path);

/// The same for any table of numbers, which needs no coordinates and may be without rows, and whose
/// numbers may be infinite or nan.
PointTable read_csv_numbers(const std::filesystem::path& path);

/// The points and the point data of a vtkPointSet. VTK always has three coordinates: if z is zero
/// for all points the table has no z, and if then y is zero for all points, no y. A field of two
/// or three components becomes name_x, name_y, ..., one of more name_0, name_1, ... Arrays of
/// strings are no columns.
PointTable read_vtk_points(const std::filesystem::path& path);

/// With a group VTKHDF at the root: the same of its Points and PointData. Without: the data sets
/// x, y, z or `position` (N x D) at the root, as they are, and all other data sets of numbers there
/// as fields. Data sets of other things than numbers, and groups, are no columns.
PointTable read_hdf5_points(const std::filesystem::path& path);

/// What the readers have in common. These errors name no file: the readers add it with `at_place`.

/// x; x and y; or x, y and z.
std::vector<std::string> coordinate_names(const std::string& array, std::size_t components);

/// The columns of a field of so many components.
std::vector<std::string> component_names(const std::string& field, std::size_t components);

/// Appends the columns of an array that holds them point by point. Throws InputError if it has
/// another length than the columns that are there.
void append(PointTable& table, const std::string& array, const std::vector<std::string>& columns,
            std::span<const double> values);

/// Takes away the coordinates that VTK added: z if all of it is zero, and then y if all of it is.
void drop_zero_coordinates(PointTable& table);

/// Throws InputError unless there is x, and y if there is z.
void check_coordinates(const PointTable& table);

/// Throws InputError unless there are points and all numbers are finite.
void check_numbers(const PointTable& table);

/// Why a number that is not finite cannot be used.
std::string not_finite(const std::string& column, std::size_t point, double value);

/// What `read` returns; its errors become InputErrors that start with the place.
template <class Read>
auto at_place(const std::string& place, Read read) {
  try {
    return read();
  } catch (const std::runtime_error& error) {
    throw InputError(place + ": " + error.what());
  }
}

}  // namespace mote
