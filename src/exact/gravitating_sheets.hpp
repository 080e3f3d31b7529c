#pragma once

#include <string_view>
#include <vector>

#include "mote/exact/exact_solution.hpp"

namespace mote {

/// Gas cells on a line at the start, in order of position. All vectors have one entry a cell.
struct SheetCells {
  std::vector<double> position;     ///< of the particle inside the cell
  std::vector<double> velocity;     ///< of the particle
  std::vector<double> length;       ///< of the cell
  std::vector<double> length_rate;  ///< velocity of the upper edge less that of the lower
  std::vector<double> mass;         ///< per unit area
  double lower = 0;                 ///< the lower edge of the first cell
  double gravity = 0;               ///< gravitational constant G
};

/// Self-gravitating pressureless gas on a line, exact until the first sheets cross (ERRATA on
/// (72)-(80) of Isshiki 2014). A sheet with mass m below it, of M in all, falls freely:
///   x = a + u0 t + g t^2/2,   g = -4 pi G (m - M/2).
/// Between its edges, which fall so too, a cell stays uniform:
///   dx = dx0 + dx0' t - 2 pi G m_i t^2,   rho = m_i/dx,
/// that is rho = rho0/(1 - 2 pi G rho0 t^2) for a start at rest.
class GravitatingSheets final : public ExactSolution {
 public:
  static constexpr std::string_view name = "gravitating_sheets";
  static constexpr std::string_view summary =
      "pressureless gas in its own gravity on a line, until the first sheets cross";

  /// Throws std::invalid_argument if the vectors differ in size or a cell has no length.
  explicit GravitatingSheets(SheetCells cells);

  /// Time at which the first cell has no length left or two neighbouring particles meet;
  /// infinite if that never happens.
  double first_crossing() const { return first_crossing_; }
  std::string statement() const override;
  double valid_until() const override { return first_crossing_; }

  Table of_particles(double time) const override;
  Table at_places(std::span<const double> position, double time) const override;
  Table curve(double time) const override;

 private:
  struct Edges {
    std::vector<double> position, velocity;
  };

  void refuse_after_crossing(double time) const;
  double length(std::size_t i, double time) const;
  /// Acceleration of a sheet with this mass below it.
  double acceleration(double mass_below) const;
  Edges edges(double time) const;

  SheetCells cells_;
  std::vector<double> mass_below_;  ///< below each particle: half its own cell counts
  double total_mass_ = 0;
  double first_velocity_ = 0;  ///< of the lowest edge at the start
  double first_crossing_ = 0;
};

}  // namespace mote
