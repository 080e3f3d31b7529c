#include "mote/study/line_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mote/particles/failure.hpp"
#include "mote/particles/images.hpp"

namespace mote {
namespace {

/// The cell of the line that the cell i beyond its ends is like.
Index image_of(Index i, Index count, const std::string& extension) {
  if (extension == "constant") return std::clamp(i, 0, count - 1);
  if (extension == "periodic") return periodic_image(i, count);
  if (extension == "mirror") return mirror_image(i, count).cell;
  return i;
}

}  // namespace

ExtendedCells extended_cells(const LayoutEntry& layout, const LineRequest& request) {
  const auto [lower, upper, count, seed, extension, beyond] = request;
  const auto relative = [&](Index i) {
    return layout.relative_length(image_of(i, count, extension), count, seed);
  };
  ExtendedCells cells;
  std::vector<double> below, inside, above;
  for (Index i = 0; i < count; ++i) inside.push_back(relative(i));
  const auto extend = [&](std::vector<double>& outside, Index end, Index direction) {
    double last = inside[end];
    bool repeats = false;
    for (Index k = 1; k <= beyond; ++k) {
      const Index i = end + direction * k;
      const double length = relative(i);
      if (length <= 0 && !repeats)
        cells.remarks.push_back(
            fmt::format("the mesh {} of {} cells has no positive length at cell {}: from there on "
                        "the cell {} is repeated",
                        layout.name, count, i, i - direction));
      repeats = repeats || length <= 0;
      if (!repeats) last = length;
      outside.push_back(last);
    }
  };
  extend(below, 0, -1);
  extend(above, count - 1, 1);
  std::ranges::reverse(below);

  // Half a cell must be a number to add to a place.
  const double resolution =
      16 * std::numeric_limits<double>::epsilon() * std::max(std::abs(lower), std::abs(upper));
  const double alpha = (upper - lower) / std::accumulate(inside.begin(), inside.end(), 0.0);
  for (const auto* part : {&below, &inside, &above})
    for (const double length : *part) cells.length.push_back(alpha * length);
  if (!(std::ranges::min(cells.length) > resolution))
    throw InputError("layouts", fmt::format("the mesh {} of {} cells has some that are closer than "
                                            "numbers can tell",
                                            layout.name, count));
  // Edges are counted from the lower end in both directions, so that it stays where it is.
  double edge = lower;
  for (Index k = beyond; k-- > 0; edge -= cells.length[k])
    cells.centre.push_back(edge - 0.5 * cells.length[k]);
  std::ranges::reverse(cells.centre);
  edge = lower;
  for (Index k = beyond; k < count + 2 * beyond; edge += cells.length[k++])
    cells.centre.push_back(edge + 0.5 * cells.length[k]);
  return cells;
}

}  // namespace mote
