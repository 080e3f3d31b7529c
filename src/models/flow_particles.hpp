#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mote/models/fluid_neighbours.hpp"
#include "mote/models/removed_fluid.hpp"
#include "mote/models/wall_motion.hpp"
#include "mote/operators/terms/pair_lines.hpp"
#include "mote/particles/cloud.hpp"

namespace mote {

/// The particles of a flow: first those of the fluid and then those of the walls, each nearly in
/// their order in space, with who is whose neighbour, periodic images included. Lists reach a skin
/// further than asked for, and last until somebody has gone half of it.
template <int D>
class FlowParticles {
 public:
  using Line = PairLine<D>;

  /// Takes the bodies of `start`; velocity and pressure of the fluid are those of its initial
  /// fields. `skin` is relative to the reach. Throws InputError for a start that does not fit.
  FlowParticles(SpaceStart start, const std::string& search, std::optional<double> skin,
                double reach);

  Cloud& cloud() { return cloud_; }
  const Cloud& cloud() const { return cloud_; }
  const SpaceStart& start() const { return start_; }
  Index count() const { return cloud_.count(); }
  Index fluids() const { return fluids_; }  ///< particles of the fluid, the first ones
  double reach() const { return reach_; }

  Eigen::Map<Vec<D>> position(Index i) { return at(position_, i); }
  Eigen::Map<Vec<D>> velocity(Index i) { return at(velocity_, i); }
  Vec<D> position(Index i) const { return Vec<D>::Map(position_.data() + std::ptrdiff_t{i} * D); }
  Vec<D> velocity(Index i) const { return Vec<D>::Map(velocity_.data() + std::ptrdiff_t{i} * D); }
  double& pressure(Index i) { return pressure_[static_cast<std::size_t>(i)]; }
  double id(Index i) const { return id_[static_cast<std::size_t>(i)]; }
  const Body& body_of(Index i) const { return start_.bodies[body_number(i)]; }
  std::size_t body_number(Index i) const {
    return static_cast<std::size_t>(body_[static_cast<std::size_t>(i)]);
  }
  /// Where wall particle i is seen from the fluid.
  const WallPlace& place_of(Index i) const;
  const WallMotion& motion_of(Index i) const { return motions_[body_number(i)]; }

  /// Notes how the walls move now; accelerations are differences over twice `half` of time.
  void observe_walls(double time, double half);
  /// Moves all for a while: the fluid by its velocities, walls that travel by what was noted.
  void drift(double duration);

  /// Finds neighbours anew if need be and brings the lines' places up to date. `travel` is how far
  /// particles are expected to go until the next time. Returns whether they were found anew.
  bool update_neighbours(double time, double travel);
  /// Finds neighbours anew the next time.
  void forget_neighbours() { lists_are_current_ = numbers_are_current_ = false; }
  /// All neighbours of everybody but those of walls among themselves, in the order of numbers.
  const NeighbourLists& lists() const { return neighbours_.lists(); }
  /// Who stands behind line k: a particle or the owner of a periodic image.
  Index owner(Index k) const {
    return k < count() ? k : neighbours_.images()[static_cast<std::size_t>(k - count())].owner;
  }
  bool is_fluid(Index k) const { return owner(k) < fluids_; }

  /// Lines of all particles and their images. Images follow their owners by `copy_to_images`.
  std::vector<Line>& lines() { return lines_; }
  const std::vector<Line>& lines() const { return lines_; }
  void copy_to_images();

  /// Takes the state of a snapshot. Throws InputError if it is not one of these particles.
  void restore(const Cloud& state);

  const RemovedFluid<D>& removed() const { return removed_; }
  std::int64_t rebuilds() const { return rebuilds_; }
  /// How often particles have got other numbers.
  std::int64_t numberings() const { return numberings_; }

 private:
  static Eigen::Map<Vec<D>> at(std::span<double> values, Index i) {
    return Vec<D>::Map(values.data() + std::ptrdiff_t{i} * D);
  }
  void name_fields();
  void fill();
  void rebuild(double time, double travel);
  void remove_what_left(double time);
  void number_by_place();

  SpaceStart start_;
  std::optional<double> skin_option_;
  double reach_, skin_ = 0, moved_ = 0;
  Cloud cloud_;
  FluidNeighbours<D> neighbours_;
  std::span<double> position_, velocity_, pressure_, body_, id_;
  std::vector<std::uint8_t> idle_;
  std::vector<Line> lines_;
  std::vector<WallMotion> motions_;
  std::vector<Index> order_;
  RemovedFluid<D> removed_;
  Index fluids_ = 0, fluids_at_start_ = 0;
  std::int64_t rebuilds_ = 0, numberings_ = 0, numbered_at_ = 0;
  bool lists_are_current_ = false, numbers_are_current_ = false;

  /// Searches until particles get numbers by their places again: what is known by number, such as a
  /// preconditioner, lasts until then, and neighbours stay near each other in memory.
  static constexpr std::int64_t most_rebuilds = 8;
};

extern template class FlowParticles<2>;
extern template class FlowParticles<3>;

}  // namespace mote
