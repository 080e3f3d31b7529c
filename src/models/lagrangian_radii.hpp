#pragma once

#include <span>
#include <vector>

namespace mote {

/// Radii that hold these parts, from 0 to 1, of the mass: each is the distance of the first body
/// from inside with which there is as much.
std::vector<double> lagrangian_radii(std::span<const double> distance, std::span<const double> mass,
                                     const std::vector<double>& parts);

}  // namespace mote
