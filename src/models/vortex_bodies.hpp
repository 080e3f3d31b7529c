#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mote/models/free_stream.hpp"
#include "mote/models/vortex_particles.hpp"
#include "mote/walls/vortex_walls.hpp"

namespace mote {

/// The bodies of a scenario in a flow of vortices in the plane: what `VortexWalls` does, with the
/// scenario's stream. All that a step needs is in the vortices, so that a restart is exact.
class VortexBodies {
 public:
  /// Throws InputError for walls that vortices cannot have, and for bodies that are thinner or
  /// closer together than the lattice resolves.
  VortexBodies(const VortexOptions& options, const VortexParticles<2>& vortices);

  /// Adds the velocity of the sheets on the walls.
  void add_velocity(const VortexParticles<2>& vortices, double time,
                    std::span<double> velocity) const;

  void begin_step(const VortexParticles<2>& vortices, double time, double step);
  /// Puts the vortices on the lattice beside the walls, where they diffuse, and adds what walls
  /// give off. Vortices are in new places afterwards.
  void end_step(VortexParticles<2>& vortices, double time, double step);

  /// Force over the density in the last step, largest velocity of slip that it left, over the whole
  /// surface, and the circulation of the sheets.
  std::vector<Reading> readings() const;
  /// On the body with this number in the start, none in the first step, where a wall gives off
  /// all at once what a flow that starts at once slips by. [force over density; per length]
  Triple force_on(std::size_t body) const;
  /// Whether some step was too short for what a wall gives off to reach the particles beside it.
  bool has_hurried() const { return has_hurried_; }
  double settling_time() const { return walls_->settling_time(); }
  std::size_t panels() const { return walls_->bodies().panels().size(); }

 private:
  std::vector<double> stream(double time) const;

  FreeStream<2> free_stream_;
  std::vector<std::size_t> numbers_;  ///< of the bodies in the start
  std::unique_ptr<VortexWalls> walls_;
  bool has_hurried_ = false;
  bool from_start_ = false;  ///< whether the last step was the first
};

}  // namespace mote
