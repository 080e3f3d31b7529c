#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mote/particles/parallel.hpp"
#include "mote/particles/vector.hpp"

namespace mote {

/// What an operator sees of the particles: first the receivers, at which derivatives are wanted,
/// then the cells that extend the region beyond its ends, which are neighbours only.
template <int D>
struct Points {
  Index receivers = 0;
  std::vector<double> position;  ///< D numbers a point
  std::vector<double> mass;
  std::vector<double> density;
  std::vector<double> circulation, vorticity;  ///< empty where there is no vorticity
  std::vector<double> length;  ///< local spacing; smoothing lengths are multiples of it
  /// Receivers whose weights nobody wants, which may have any neighbourhood; empty: none.
  std::vector<std::uint8_t> exempt;

  bool needs_weights(Index i) const {
    return exempt.empty() || exempt[static_cast<std::size_t>(i)] == 0;
  }

  Index size() const { return static_cast<Index>(length.size()); }

  void resize(Index size, Index receiver_count) {
    receivers = receiver_count;
    position.resize(static_cast<std::size_t>(size) * D);
    for (auto* values : {&mass, &density, &length}) values->resize(static_cast<std::size_t>(size));
  }

  /// Position of point i.
  Vec<D> at(Index i) const { return Vec<D>::Map(position.data() + std::ptrdiff_t{i} * D); }
};

}  // namespace mote
