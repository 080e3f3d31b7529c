#include "mote/walls/cut_lattice.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mote/walls/clipping.hpp"

namespace mote {
namespace {

constexpr int margin = 4;  ///< whole cells around the bodies
constexpr double whole = 1;

double distance(const Panel& panel, Complex place) {
  const Complex side = panel.to - panel.from, offset = place - panel.from;
  const double along = std::clamp((std::conj(side) * offset).real() / std::norm(side), 0.0, 1.0);
  return std::abs(offset - along * side);
}

double distance(std::span<const Panel> panels, Complex place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Panel& panel : panels) nearest = std::min(nearest, distance(panel, place));
  return nearest;
}

/// Places where the panels pass the line of this y, in order.
std::vector<double> crossings(std::span<const Panel> panels, double y) {
  std::vector<double> x;
  for (const auto& [from, to] : panels)
    if ((from.imag() > y) != (to.imag() > y))
      x.push_back(from.real() +
                  (to.real() - from.real()) * (y - from.imag()) / (to.imag() - from.imag()));
  std::ranges::sort(x);
  return x;
}

/// Calls `visit` with every cell that a panel may touch.
template <class Visit>
void visit_cells_along(const Panel& panel, const CutLattice& lattice, Visit visit) {
  const Complex from = lattice.in_spacings(panel.from), to = lattice.in_spacings(panel.to);
  const auto range = [&](double a, double b) {
    const auto [low, high] = std::minmax(a, b);
    return std::pair(static_cast<int>(std::floor(low + 0.5 - 1e-9)),
                     static_cast<int>(std::floor(high + 0.5 + 1e-9)));
  };
  const auto [left, right] = range(from.real(), to.real());
  const auto [bottom, top] = range(from.imag(), to.imag());
  for (int j = bottom; j <= top; ++j)
    for (int i = left; i <= right; ++i) visit(i, j);
}

}  // namespace

NodeBox NodeBox::joined(const NodeBox& other) const {
  if (count() == 0) return other;
  if (other.count() == 0) return *this;
  NodeBox both{std::min(first_i, other.first_i), std::min(first_j, other.first_j)};
  both.columns = std::max(first_i + columns, other.first_i + other.columns) - both.first_i;
  both.rows = std::max(first_j + rows, other.first_j + other.rows) - both.first_j;
  return both;
}

CutLattice::CutLattice(const PanelBodies& bodies, double spacing, Complex origin)
    : spacing_(spacing), origin_(origin) {
  lay_out(bodies);
  cut_cells(bodies);
  choose_owners(bodies);
  for (std::size_t cell = 0; cell < box_.count(); ++cell) {
    connect(cell, 1, 0, std::exchange(open_right_[cell], 0));
    connect(cell, 0, 1, std::exchange(open_above_[cell], 0));
  }
  share_panels(bodies);
}

/// The box, with every cell whole or, if its node is inside a body, solid.
void CutLattice::lay_out(const PanelBodies& bodies) {
  for (const Panel& panel : bodies.panels()) {
    const Complex end = in_spacings(panel.from);
    box_ = box_.joined({static_cast<int>(std::floor(end.real())) - margin,
                        static_cast<int>(std::floor(end.imag())) - margin, 2 * margin + 2,
                        2 * margin + 2});
  }
  area_.assign(box_.count(), spacing_ * spacing_);
  for (std::size_t cell = 0; cell < box_.count(); ++cell)
    place_.push_back(node(box_.i(cell), box_.j(cell)));
  open_right_.assign(box_.count(), whole);
  open_above_.assign(box_.count(), whole);
  for (int j = box_.first_j; j < box_.first_j + box_.rows; ++j) {
    const std::vector<double> x = crossings(bodies.panels(), node(0, j).imag());
    for (int i = box_.first_i; i < box_.first_i + box_.columns; ++i)
      if (const auto to_the_left = std::ranges::lower_bound(x, node(i, j).real()) - x.begin();
          to_the_left % 2 == 1) {
        const std::size_t cell = box_.place(i, j);
        area_[cell] = open_right_[cell] = open_above_[cell] = 0;
      }
  }
}

void CutLattice::cut_cells(const PanelBodies& bodies) {
  std::vector<std::size_t> cut;
  for (const Panel& panel : bodies.panels())
    visit_cells_along(panel, *this, [&](int i, int j) { cut.push_back(box_.place(i, j)); });
  std::ranges::sort(cut);
  cut.erase(std::ranges::unique(cut).begin(), cut.end());
  for (const std::size_t cell : cut) {
    Cover sum;
    for (std::size_t body = 0; body < bodies.body_count(); ++body) {
      const Cover cover = cover_of(bodies.panels(body), place_[cell], spacing_);
      sum.area += cover.area, sum.right += cover.right, sum.above += cover.above;
      sum.moment += cover.moment;
    }
    area_[cell] = std::max(0.0, spacing_ * spacing_ - sum.area);
    if (area_[cell] > 0 && sum.area > 0) place_[cell] -= sum.moment / area_[cell];
    open_right_[cell] = std::max(0.0, whole - sum.right / spacing_);
    open_above_[cell] = std::max(0.0, whole - sum.above / spacing_);
  }
}

bool CutLattice::is_outside(const PanelBodies& bodies, Complex place) const {
  const std::vector<double> x = crossings(bodies.panels(), place.imag());
  const auto to_the_left = std::ranges::lower_bound(x, place.real()) - x.begin();
  return to_the_left % 2 == 0 && distance(bodies.panels(), place) >= least_distance * spacing_;
}

/// The centroid moves along, unless that would bring it into a body.
void CutLattice::take_over(const PanelBodies& bodies, std::size_t owner, std::size_t cell) {
  const double sum = area_[owner] + area_[cell];
  const Complex centroid = (area_[owner] * place_[owner] + area_[cell] * place_[cell]) / sum;
  if (is_outside(bodies, centroid)) place_[owner] = centroid;
  area_[owner] = sum;
  area_[cell] = 0;
}

void CutLattice::choose_owners(const PanelBodies& bodies) {
  constexpr double rounding = 1e-9;
  const double square = spacing_ * spacing_;
  owner_.assign(box_.count(), nobody);
  for (std::size_t cell = 0; cell < box_.count(); ++cell)
    if (area_[cell] > (1 - rounding) * square ||
        (area_[cell] > (least_area - rounding) * square && is_outside(bodies, place_[cell])))
      owner_[cell] = cell;
  std::vector<std::size_t> owner = owner_;
  for (std::size_t cell = 0; cell < box_.count(); ++cell)
    if (owner_[cell] == nobody && area_[cell] > rounding * square)
      owner[cell] = nearest_carrier(cell);
    else if (owner_[cell] == nobody)
      area_[cell] = 0;
  for (std::size_t cell = 0; cell < box_.count(); ++cell)
    if (owner[cell] != cell && owner[cell] != nobody) take_over(bodies, owner[cell], cell);
  owner_ = owner;
}

/// The neighbour with the longest common face, else the nearest of those around it. In a fixed
/// order that does not tell above from below by rounding.
std::size_t CutLattice::nearest_carrier(std::size_t cell) const {
  const int i = box_.i(cell), j = box_.j(cell);
  const std::size_t left = box_.place(i - 1, j), below = box_.place(i, j - 1);
  const std::pair<std::size_t, double> beside[] = {{box_.place(i + 1, j), open_right_[cell]},
                                                   {left, open_right_[left]},
                                                   {box_.place(i, j + 1), open_above_[cell]},
                                                   {below, open_above_[below]}};
  constexpr double rounding = 1e-9;
  std::size_t best = nobody;
  double longest = rounding;
  for (const auto& [other, open] : beside)
    if (owner_[other] == other && open > longest + rounding) best = other, longest = open;
  double nearest = 9;  // the square of a distance
  for (int dj = -2; dj <= 2 && longest == rounding; ++dj)
    for (int di = -2; di <= 2; ++di)
      if (const std::size_t other = box_.place(i + di, j + dj);
          owner_[other] == other && di * di + dj * dj < nearest)
        best = other, nearest = di * di + dj * dj;
  return best;
}

/// Keeps the face between a cell and its neighbour to the right or above.
void CutLattice::connect(std::size_t a, int di, int dj, double open) {
  auto& faces = di == 1 ? open_right_ : open_above_;
  const int i = box_.i(a) + di, j = box_.j(a) + dj;
  if (!box_.holds(i, j)) {
    faces[a] = whole;
    return;
  }
  const std::size_t b = box_.place(i, j), from = owner_[a], to = owner_[b];
  if (from == to || from == nobody || to == nobody || open <= 0) return;
  const double distance = std::abs(place_[from] - place_[to]);
  if (from == a && to == b)
    faces[a] = open * spacing_ / distance;
  else
    links_.push_back({from, to, open * spacing_ / distance});
}

void CutLattice::share_panels(const PanelBodies& bodies) {
  constexpr double outwards = 1e-6;  // spacings: a panel on a face belongs to the fluid's cell
  for (std::size_t k = 0; k < bodies.panels().size(); ++k) {
    Panel panel = bodies.panels()[k];
    const Complex shift = outwards * spacing_ * panel.normal();
    panel = {panel.from + shift, panel.to + shift};
    const std::size_t first = shares_.size();
    double sum = 0;
    visit_cells_along(panel, *this, [&](int i, int j) {
      const Piece piece = piece_inside(panel, node(i, j), spacing_);
      if (piece.from >= piece.to) return;
      const std::size_t cell = box_.place(i, j);
      const std::size_t owner = owner_[cell] == nobody ? nearest_carrier(cell) : owner_[cell];
      if (owner == nobody) return;
      const Complex offset = place_[owner] - panel.from;
      const double away = std::abs((std::conj(panel.normal()) * offset).real());
      shares_.push_back({owner, k, piece.to - piece.from, away});
      sum += piece.to - piece.from;
    });
    for (std::size_t n = first; n < shares_.size(); ++n) shares_[n].fraction /= sum;
  }
}

}  // namespace mote
