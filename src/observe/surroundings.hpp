#pragma once

#include <vector>

#include "mote/models/model.hpp"

namespace mote {

/// A box; places within it are looked at.
template <int D>
struct Box {
  Vec<D> lower, upper;
};

/// A particle, or its image beyond a periodic side of the domain.
template <int D>
struct Seen {
  Vec<D> position;
  Index particle;
};

/// The part that a particle's value has in the value at a place. The parts sum to 1.
struct Share {
  Index particle;
  double part;
};

/// How far a place sees: 3 spacings. A plane surface then still leaves 14 particles in a plane and
/// 56 in space, a corner half of them or a quarter, and a linear function needs 3 or 4.
inline constexpr double sight = 3;

/// The particles of a model in space around the places in a box, in the model's order.
template <int D>
class Surroundings {
 public:
  /// `period` is the width of the domain along each periodic axis, and 0 along the others.
  Surroundings(const Model& model, const Triple& period, const Box<D>& box);

  const std::vector<Seen<D>>& fluid() const { return fluid_; }

  /// The one rule by which fields have values between particles: the linear function that fits
  /// those of the fluid within sight best, weighted by Wendland's C2 kernel with that support. It
  /// is exact for linear fields, at the rim of the fluid too. Where the particles lie within a
  /// tenth of a spacing of a line (a plane, in space) the slope across is unknown, and the weighted
  /// mean is taken. Walls have no part. Empty where there is no fluid within sight.
  std::vector<Share> shares(const Vec<D>& place) const;

  /// The part of the surroundings without walls that fluid fills: sum V W over the fluid, over 1
  /// less the same over the walls. One half on a plane surface, also beside a wall; 0 inside walls.
  double filled(const Vec<D>& place) const;

 private:
  double kernel(const Vec<D>& from, const Vec<D>& to) const;

  double spacing_;
  std::vector<Seen<D>> fluid_, walls_;
};

extern template class Surroundings<2>;
extern template class Surroundings<3>;

}  // namespace mote
