#include "mote/input/point_table.hpp"

namespace mote {

PointTable read_vtk_points(const std::filesystem::path& path) {
  throw InputError(
      path.string() +
      ": this mote was built without VTK and cannot read this file; give .csv or .hdf");
}

}  // namespace mote
