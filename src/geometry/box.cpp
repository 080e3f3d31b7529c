#include "mote/geometry/box.hpp"

#include <algorithm>
#include <cmath>

namespace mote {

double Box::distance(const Triple& place) const {
  Triple outside{};
  double highest = -Extent::endless;
  for (int d = 0; d < 3; ++d) {
    const double beyond = std::max(extent_.lower[d] - place[d], place[d] - extent_.upper[d]);
    outside[d] = std::max(beyond, 0.0);
    highest = std::max(highest, beyond);
  }
  return highest > 0 ? std::hypot(outside[0], outside[1], outside[2]) : highest;
}

}  // namespace mote
