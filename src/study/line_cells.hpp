#pragma once

#include <string>
#include <vector>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// A line's cells that fill [lower, upper], and `beyond` more at each end.
struct LineRequest {
  double lower = 0, upper = 1;
  Index count = 0;
  std::uint64_t seed = 0;
  std::string extension = "formula";  ///< formula, constant, mirror or periodic
  Index beyond = 0;
};

/// Cells by rising position: `beyond`, then those of the line, then `beyond` again.
struct ExtendedCells {
  std::vector<double> centre, length;
  std::vector<std::string> remarks;
};

/// The cells of a mesh of Isshiki (2014), Table 2, continued beyond its ends. Where the formula has
/// no positive length, as for the algebraic mesh, the last positive cell is repeated.
ExtendedCells extended_cells(const LayoutEntry& layout, const LineRequest& request);

}  // namespace mote
