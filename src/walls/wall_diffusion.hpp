#pragma once

#include <span>

#include "mote/walls/lattice_vorticity.hpp"

namespace mote {

/// Diffusion of particles on a cut lattice, and of what their walls give off. Neighbours exchange
/// circulation, so that it is conserved to rounding,
///   dGamma_i/dt = nu sum_j L_ij/|x_i - x_j| (Gamma_j/A_j - Gamma_i/A_i) + s_i,
/// with open face lengths L and fluid areas A: particle strength exchange between nearest nodes,
/// where walls let nothing through. As the open faces of a cell and its piece of wall close, the
/// linear impulse changes as the vorticity at the wall says, nu times the integral of omega n.
/// s_i is the vorticity that the wall gives off: a sheet of strength gamma enters the fluid as the
/// flux -nu domega/dn = gamma/dt (Koumoutsakos, Leonard & Pepin 1994) through the pieces of panels
/// in a cell.
class WallDiffusion {
 public:
  WallDiffusion(const CutLattice& lattice, double viscosity)
      : lattice_(&lattice), viscosity_(viscosity) {}

  /// Lets the vorticity diffuse for a time; none passes the walls.
  void diffuse(double time, LatticeVorticity& vorticity) const;

  /// When a sheet enters the fluid: evenly during the time, or at its start, as the sheet of a flow
  /// that starts at once does.
  enum class Release { evenly, at_start };

  /// Adds what the sheet on the panels becomes in a time: its circulation (strength times length)
  /// enters the fluid and diffuses. The box must hold the box of the lattice.
  void add_sheet(std::span<const double> circulation, double time, Release release,
                 LatticeVorticity& vorticity) const;

  /// Vorticity at every panel: what the particles beside it have, carried on to the wall by the
  /// slope -nu domega/dn = strength/time at which the panel gives off this sheet.
  std::vector<double> wall_vorticity(std::span<const double> sheet, double time,
                                     const LatticeVorticity& vorticity) const;

 private:
  struct Coefficients;
  Coefficients coefficients(const NodeBox& box) const;
  int steps(double time) const;
  double late_part(int step, int count, const PanelShare& share, double time) const;

  const CutLattice* lattice_;
  double viscosity_;
};

}  // namespace mote
