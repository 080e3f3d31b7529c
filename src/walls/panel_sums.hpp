#pragma once

#include <span>

#include "mote/walls/panel.hpp"

namespace mote {

/// Point vortices in the plane.
struct Vortices {
  std::span<const Complex> place;
  std::span<const double> circulation;
};

/// Adds the integral of the vortices' velocity along every panel. O(panels vortices), eight at a
/// time.
void add_circulations(std::span<const Panel> panels, const Vortices& vortices,
                      std::span<double> result);

/// Adds the velocity of sheets of this strength on the panels.
void add_sheet_velocities(std::span<const Panel> panels, std::span<const double> strength,
                          std::span<const Complex> places, std::span<Complex> velocity);

}  // namespace mote
