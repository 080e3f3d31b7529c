#pragma once

#include "mote/particles/vector.hpp"

namespace mote {

/// The cell among `count` that the cell i is a periodic image of.
constexpr Index periodic_image(Index i, Index count) { return (i % count + count) % count; }

/// The cell that another is a mirror image of, and whether it stands the other way round.
struct MirrorImage {
  Index cell;
  bool reversed;
};

/// The cell among `count` that the cell i is an image of in mirrors at both ends.
constexpr MirrorImage mirror_image(Index i, Index count) {
  const Index k = periodic_image(i, 2 * count);
  return k < count ? MirrorImage{k, false} : MirrorImage{2 * count - 1 - k, true};
}

}  // namespace mote
