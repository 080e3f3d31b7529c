#pragma once

#include <array>
#include <span>
#include <vector>

#include "mote/walls/wall_diffusion.hpp"
#include "mote/walls/wall_remeshing.hpp"

namespace mote {

struct VortexWallOptions {
  double spacing = 0;         ///< of the lattice that vortices are put on [length]
  Complex node{};             ///< a node of that lattice
  double panel_length = 2.5;  ///< at most, in spacings; shorter ones see single vortices
  double viscosity = 0;       ///< kinematic [length^2/time]
  double threshold = 1e-6;    ///< nodes below it, over the largest circulation, stay empty; what
                              ///< is lost at 1e-4 shows in forces
  double circulation = 0;     ///< of all vortices and of the flow around the bodies, at the start
};

/// Vortices as bare numbers: two for the place of each, and its circulation.
struct PlaneVortices {
  std::span<const double> position, circulation;
};

/// Bodies that stand still in a flow of vortices in the plane, with no slip. A step is split
/// (Koumoutsakos, Leonard & Pepin 1994): vortices move, with the sheets that keep fluid out of the
/// bodies; they are put on a lattice beside the walls; vorticity diffuses there; and the sheet of
/// what slip is left enters the fluid. All steps conserve circulation, and whatever weak vortices
/// take with them, sheets give back. Results do not depend on the number of threads.
class VortexWalls {
 public:
  VortexWalls(std::span<const Outline> bodies, const VortexWallOptions& options);

  const PanelBodies& bodies() const { return bodies_; }
  const CutLattice& lattice() const { return lattice_; }
  /// Middles of the panels, two numbers each: where the functions below want the free stream.
  std::span<const double> panel_places() const { return panel_places_; }

  /// Adds, at any places, the velocity of the sheets that let no fluid through in a flow of these
  /// vortices and this stream. Two numbers a place.
  void add_velocity(const PlaneVortices& vortices, std::span<const double> stream,
                    std::span<const double> places, std::span<double> velocity) const;

  /// Takes notice of the impulse before a step.
  void begin_step(const PlaneVortices& vortices, std::span<const double> stream);

  /// In which vorticity spreads from a wall to the particles beside it. Shorter steps are stable,
  /// but make a flow that starts at once look older by as much. [time]
  double settling_time() const {
    return 0.15 * options_.spacing * options_.spacing / options_.viscosity;
  }

  struct Replaced {
    std::vector<double> position, circulation, area;
  };
  /// All but the motion: the vortices that there are after a step, in the order of nodes.
  /// `release` is `at_start` in the first step of a flow that starts at once.
  Replaced end_step(const PlaneVortices& vortices, std::span<const double> stream, double step,
                    WallDiffusion::Release release);

  /// Mean force of the fluid on all bodies in the last step over the density, less the buoyancy of
  /// an accelerated stream: the loss of impulse, -d/dt of the sum of circulation times (y, -x) over
  /// vortices and sheets. In a fluid at rest inside the bodies there is no other.
  std::array<double, 2> force() const { return force_; }

  /// The same for one body, by what happens at its wall: friction, from the vorticity there, and
  /// pressure, whose slope along the wall is -1/step times the strength of the sheet that is given
  /// off. It needs a viscosity; the sum over the bodies agrees with `force` but for errors.
  /// Nothing before the first step.
  std::array<double, 2> force_on(std::size_t body) const;
  /// Vorticity at every panel, the mean over the last step.
  std::span<const double> wall_vorticity() const { return wall_vorticity_; }

  /// Strength of the sheets that the last step left, which is the velocity of slip, on every panel.
  std::span<const double> slip() const { return slip_; }
  /// What weak vortices took with them in the last step; the circulation comes back in the next.
  const LostVorticity& lost() const { return lost_; }

 private:
  std::vector<double> sheet(const Vortices& vortices, std::span<const double> stream) const;
  Complex impulse(const Vortices& vortices, std::span<const double> sheet) const;
  LatticeVorticity lattice_vorticity(const Vortices& vortices, double step);
  void give_off(std::span<const double> stream, double step, WallDiffusion::Release release,
                LatticeVorticity& vorticity);

  VortexWallOptions options_;
  PanelBodies bodies_;
  CutLattice lattice_;
  WallDiffusion diffusion_;
  std::vector<double> panel_places_, slip_, given_, wall_vorticity_;
  double step_ = 0;                    ///< the last one
  LatticeVorticity vorticity_before_;  ///< diffusion
  Complex impulse_before_{};
  LostVorticity lost_;
  std::array<double, 2> force_{};
};

}  // namespace mote
