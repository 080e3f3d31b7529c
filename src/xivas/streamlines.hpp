#pragma once

#include <optional>

#include "mote/particles/compensated_sum.hpp"
#include "mote/xivas/nodal_field.hpp"

namespace mote {

/// What a material point has beside the fields on the mesh and keeps on its way.
template <int D>
struct OwnMotion {
  Vec<D> velocity = Vec<D>::Zero(), acceleration = Vec<D>::Zero();
};

/// A material point on its way through a mesh.
template <int D>
struct Passage {
  Vec<D> position;
  Index cell;                       ///< that it is in, or left the mesh from
  CompensatedSum time = {};         ///< how long it was under way
  bool left = false;                ///< whether it came to the hull, where it stays
  Vec<D> outward = Vec<D>::Zero();  ///< normal of the hull where it left
  int crossings = 0;                ///< of faces
  Vec<D> gain = Vec<D>::Zero();     ///< the second field, integrated along its way
  OwnMotion<D> own = {};
};

/// Streamlines of a piecewise linear velocity, followed exactly from cell to cell: Nadukandi 2014,
/// section 3, with (28) corrected. A second field, the acceleration, is integrated along them as in
/// (24).
///
/// A point leaves a cell when it is past a face by about the tolerance of the mesh, and so has
/// entered the next one: whoever touches a face, runs within it or starts on it is no special case.
/// Through an edge or a corner it goes by the walk that finds places, and the velocity is
/// continuous: it cannot go to and fro.
template <int D>
class Streamlines {
 public:
  explicit Streamlines(NodalField<D> velocity,
                       std::optional<NodalField<D>> acceleration = std::nullopt)
      : velocity_(velocity), acceleration_(acceleration) {}

  const NodalField<D>& velocity() const { return velocity_; }

  /// The velocity of a point where it is, and its acceleration; a field that is missing is 0.
  Vec<D> velocity(const Passage<D>& at) const {
    return velocity_.value(at.cell, at.position) + at.own.velocity;
  }
  Vec<D> acceleration(const Passage<D>& at) const;

  /// Where a point in this cell is after so much time, or where and when it left the mesh. Throws
  /// NumericalFailure for values that are not finite.
  Passage<D> follow(const Vec<D>& from, Index cell, double time,
                    const OwnMotion<D>& own = {}) const;

  /// Goes on with a passage that is in the mesh until it was under way for so long, or left.
  void continue_to(double time, Passage<D>& at) const;

  /// The largest part of the height of a cell that its velocities go through in so much time: the
  /// Courant number of a step on this mesh.
  double courant_number(double time) const;

 private:
  bool stays(const Mat<D>& gradient, const Vec<D>& velocity, const Passage<D>& at,
             double time) const;
  void finish_within(const Mat<D>& gradient, const Vec<D>& velocity, double time,
                     Passage<D>& at) const;
  void go_on(const Mat<D>& gradient, const Vec<D>& velocity, double time, Passage<D>& at) const;
  void add_gain(double time, const Vec<D>& integral, Passage<D>& at) const;

  NodalField<D> velocity_;
  std::optional<NodalField<D>> acceleration_;
};

extern template class Streamlines<2>;
extern template class Streamlines<3>;

}  // namespace mote
