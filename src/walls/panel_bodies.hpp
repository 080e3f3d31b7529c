#pragma once

#include <Eigen/LU>
#include <span>
#include <vector>

#include "mote/walls/outline.hpp"
#include "mote/walls/panel_sums.hpp"

namespace mote {

/// Bodies that stand still in a flow, and the vortex sheets on their surfaces that keep the
/// velocity inside them at zero: the surface integral of Isshiki (2014), (38), with eps = 0 inside.
/// As the flow inside has no sources and no vorticity, a tangential velocity of zero on the inner
/// side is enough, and no fluid passes either. On a panel, with the sheet strength gamma constant
/// on each,
///   -gamma/2 + (velocity of everything else) . t = 0,
/// a Fredholm equation of the second kind, here in the mean over every panel with exact integrals.
/// The fluid slips along the outer side with the velocity gamma. The equations of a body sum to 0,
/// so the circulation of every body's sheet is to be given (Kelvin's theorem).
class PanelBodies {
 public:
  /// Cuts the outlines into panels no longer than `panel_length` and factors the matrix, in
  /// O(panels^3). Throws InputError for what is no polygon and for more panels than `most_panels`.
  PanelBodies(std::span<const Outline> bodies, double panel_length);

  static constexpr std::size_t most_panels = 10000;

  std::span<const Panel> panels() const { return panels_; }
  std::size_t body_count() const { return first_panel_.size() - 1; }
  /// The panels of one body.
  std::span<const Panel> panels(std::size_t body) const;

  /// Integral of the velocity of a uniform stream and of vortices along every panel; vortices of
  /// zero size, so that none reaches into a body.
  std::vector<double> circulation_along_panels(Complex stream, const Vortices& vortices) const;

  /// Strength of the sheet on every panel for these circulations along the panels and the total
  /// circulation of every body's sheet.
  std::vector<double> sheet(std::span<const double> along_panels,
                            std::span<const double> circulation) const;

  /// Adds the velocity of a sheet at any places off the surface.
  void add_velocity(std::span<const double> sheet, std::span<const Complex> places,
                    std::span<Complex> velocity) const;

  /// Total circulation of a body's sheet.
  double circulation(std::span<const double> sheet, std::size_t body) const;

 private:
  Eigen::MatrixXd equations() const;

  std::vector<Panel> panels_;
  std::vector<std::size_t> first_panel_;  ///< of every body, and the end
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace mote
