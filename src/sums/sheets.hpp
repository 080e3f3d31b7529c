#pragma once

#include <span>

namespace mote {

/// Gravity of infinite plane sheets on a line, summed over all pairs in O(N). Sheets stand in
/// order of position; `mass` is per unit area and `gravity` the gravitational constant G.

/// Acceleration of every sheet: 2 pi G times the mass above it less the mass below it.
void sheet_acceleration(std::span<const double> mass, double gravity,
                        std::span<double> acceleration);

/// The potential of the sheets at any places, sum_j 2 pi G m_j |x - x_j|, the solution of (72c) by
/// the Green function (39b) of Isshiki (2014). `place` may be in any order; O((N + M) log N).
/// `mass_below` and `moment_below` are work arrays of N + 1 numbers.
void sheet_potential(std::span<const double> position, std::span<const double> mass, double gravity,
                     std::span<const double> place, std::span<double> mass_below,
                     std::span<double> moment_below, std::span<double> potential);

/// Potential energy per unit area, sum over pairs of 2 pi G m_i m_j |x_i - x_j|.
double sheet_energy(std::span<const double> position, std::span<const double> mass, double gravity);

}  // namespace mote
