#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "mote/walls/panel_bodies.hpp"

namespace mote {

/// A rectangle of lattice nodes, row by row.
struct NodeBox {
  int first_i = 0, first_j = 0, columns = 0, rows = 0;

  std::size_t count() const { return static_cast<std::size_t>(columns) * rows; }
  bool holds(int i, int j) const {
    return i >= first_i && i < first_i + columns && j >= first_j && j < first_j + rows;
  }
  std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(j - first_j) * columns + (i - first_i);
  }
  int i(std::size_t place) const { return first_i + static_cast<int>(place % columns); }
  int j(std::size_t place) const { return first_j + static_cast<int>(place / columns); }
  /// The smallest that holds both.
  NodeBox joined(const NodeBox& other) const;
};

/// Flow between two cells in direct contact: per difference of vorticity and per viscosity.
struct CellLink {
  std::size_t a, b;  ///< places in the box of the cut lattice
  double conductance;
};

/// A part of a panel and the cell that it lies in.
struct PanelShare {
  std::size_t cell, panel;
  double fraction;
  double distance;  ///< of the cell's particle from the panel's line
};

/// A square lattice that bodies are cut out of, cell by cell with exact areas. A cell carries a
/// particle unless less than `least_area` of it is open; what is left of the others belongs to a
/// neighbour that does. The particle of a cut cell stands at the centroid of what the cell holds.
/// Bodies and the gaps between them should be at least three spacings wide.
class CutLattice {
 public:
  /// Node (0, 0) stands at `origin`, in the middle of its cell.
  CutLattice(const PanelBodies& bodies, double spacing, Complex origin = 0);

  static constexpr double least_area = 0.5;      ///< over the area of a whole cell
  static constexpr double least_distance = 0.2;  ///< of particles from a surface, in spacings
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);

  double spacing() const { return spacing_; }
  Complex node(int i, int j) const { return origin_ + spacing_ * Complex(i, j); }
  /// A place in numbers of nodes.
  Complex in_spacings(Complex place) const { return (place - origin_) / spacing_; }
  /// Where the particle of a cell stands.
  Complex place(int i, int j) const {
    return box_.holds(i, j) ? place_[box_.place(i, j)] : node(i, j);
  }
  /// What lies around the bodies; all cells beyond are whole.
  const NodeBox& box() const { return box_; }
  bool carries(int i, int j) const {
    return !box_.holds(i, j) || owner_[box_.place(i, j)] == box_.place(i, j);
  }
  /// Whether the cell is whole and its particle stands at its node.
  bool is_whole(int i, int j) const {
    return carries(i, j) && (!box_.holds(i, j) || place_[box_.place(i, j)] == node(i, j));
  }
  /// The node that carries what is in a cell, by places in the box, or `nobody`.
  std::size_t owner(std::size_t cell) const { return owner_[cell]; }
  /// Fluid area of a node's cell with what it has taken over. [length^2]
  double area(std::size_t cell) const { return area_[cell]; }
  double area(int i, int j) const {
    return box_.holds(i, j) ? area_[box_.place(i, j)] : spacing_ * spacing_;
  }
  /// Open length of the faces to the right and above, over the spacing, of nodes that carry a
  /// particle on both sides; 0 otherwise.
  double open_right(std::size_t cell) const { return open_right_[cell]; }
  double open_above(std::size_t cell) const { return open_above_[cell]; }
  /// The other contacts, of cells that have been taken over.
  std::span<const CellLink> links() const { return links_; }
  /// Where the panels lie; the fractions of a panel sum to 1.
  std::span<const PanelShare> shares() const { return shares_; }

 private:
  void lay_out(const PanelBodies& bodies);
  void cut_cells(const PanelBodies& bodies);
  void choose_owners(const PanelBodies& bodies);
  bool is_outside(const PanelBodies& bodies, Complex place) const;
  void take_over(const PanelBodies& bodies, std::size_t owner, std::size_t cell);
  void connect(std::size_t a, int di, int dj, double open);
  void share_panels(const PanelBodies& bodies);
  std::size_t nearest_carrier(std::size_t cell) const;

  double spacing_;
  Complex origin_;
  NodeBox box_;
  std::vector<double> area_, open_right_, open_above_;
  std::vector<Complex> place_;
  std::vector<std::size_t> owner_;
  std::vector<CellLink> links_;
  std::vector<PanelShare> shares_;
};

}  // namespace mote
