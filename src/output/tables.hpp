#pragma once

#include <filesystem>
#include <string>

#include "mote/exact/exact_solution.hpp"
#include "mote/particles/cloud.hpp"

namespace mote {

/// The cloud as CSV: id,x[,y,z], then fields by name, vectors as name_x,name_y,...; 17 digits. Rows
/// are in order of their ids.
std::string csv_of(const Cloud& cloud);

/// A table as CSV with 17 digits.
std::string csv_of(const Table& table);

/// Writes the cloud as inline VTK XML PolyData, one vertex a particle, in order of ids. Throws
/// InputError when it cannot, also in a build without VTK.
void write_vtp(const std::filesystem::path& path, const Cloud& cloud);

}  // namespace mote
