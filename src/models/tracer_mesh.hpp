#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mote/models/free_stream.hpp"
#include "mote/models/tracers_options.hpp"
#include "mote/xivas/streamlines.hpp"

namespace mote {

/// The first of these places at which the velocity is not finite, in words; none if there is none.
template <int D>
std::optional<std::string> first_without_value(std::span<const double> places,
                                               std::span<const double> velocity);

/// Throws InputError for a place without a velocity at the start.
template <int D>
void refuse_velocities_without_value(std::span<const double> places,
                                     std::span<const double> velocity);

/// A velocity by formulas, interpolated on a mesh of simplices that fills a box, sides of which may
/// be one: what leaves there comes in on the other side.
template <int D>
class TracerMesh {
 public:
  /// Throws InputError for a velocity that is not finite, or not periodic where the box is.
  TracerMesh(const TracersOptions& options, const SpaceStart& start, const FreeStream<D>& velocity);

  /// Takes the velocities at this time. Throws NumericalFailure for one that is not finite.
  void take_velocities(double time);

  /// The cell of a place in the box, looked for from another, and how its tracer goes on from there
  /// for so long; `time` of the passage counts all sides it went through. Throw NumericalFailure
  /// for a place outside.
  Index locate(const Vec<D>& place, Index from) const;
  Passage<D> follow(const Vec<D>& from, Index cell, double time) const;

  /// Of the last velocities taken.
  double courant_number(double step) const { return streamlines_.courant_number(step); }

 private:
  void refuse_other_velocities_across_sides() const;
  bool comes_in_again(Passage<D>& at) const;

  const SpaceStart& start_;
  const FreeStream<D>& velocity_;
  SimplexMesh<D> mesh_;
  std::vector<double> places_;  ///< of its points; of those on an upper periodic side the lower one
  std::vector<double> values_;
  Streamlines<D> streamlines_;
};

extern template class TracerMesh<2>;
extern template class TracerMesh<3>;

}  // namespace mote
