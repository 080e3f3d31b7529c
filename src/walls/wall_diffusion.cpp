#include "mote/walls/wall_diffusion.hpp"

#include <algorithm>
#include <cmath>

namespace mote {
namespace {

/// Of a sheet that is given off evenly, by the trapezoidal rule.
double even_part(int step, int count) { return (step == 0 || step == count ? 0.5 : 1.0) / count; }

}  // namespace

/// Of every node of a box: one over its area, and its links.
struct WallDiffusion::Coefficients {
  NodeBox box;
  std::vector<double> per_area, right, above;
  std::vector<CellLink> links;

  void advance(double factor, std::vector<double>& circulation, std::vector<double>& omega) const;
};

WallDiffusion::Coefficients WallDiffusion::coefficients(const NodeBox& box) const {
  Coefficients result{.box = box};
  const NodeBox& cut = lattice_->box();
  result.per_area.assign(box.count(), 1 / (lattice_->spacing() * lattice_->spacing()));
  result.right.assign(box.count(), 1);
  result.above.assign(box.count(), 1);
  const auto place = [&](std::size_t cell) { return box.place(cut.i(cell), cut.j(cell)); };
  for (std::size_t cell = 0; cell < cut.count(); ++cell) {
    const double area = lattice_->area(cell);
    result.per_area[place(cell)] = lattice_->owner(cell) == cell ? 1 / area : 0;
    result.right[place(cell)] = lattice_->open_right(cell);
    result.above[place(cell)] = lattice_->open_above(cell);
  }
  for (const CellLink& link : lattice_->links())
    result.links.push_back({place(link.a), place(link.b), link.conductance});
  return result;
}

/// One explicit step; `factor` is viscosity times time. Nothing passes the rim of the box.
void WallDiffusion::Coefficients::advance(double factor, std::vector<double>& circulation,
                                          std::vector<double>& omega) const {
  const std::size_t columns = box.columns;
  for (std::size_t k = 0; k < omega.size(); ++k) omega[k] = factor * circulation[k] * per_area[k];
#pragma omp parallel for schedule(static)
  for (int row = 0; row < box.rows; ++row) {
    const std::size_t first = row * columns;
    for (std::size_t k = first; k < first + columns; ++k) {
      const double from_right = k + 1 < first + columns ? right[k] * (omega[k + 1] - omega[k]) : 0;
      const double to_left = k > first ? right[k - 1] * (omega[k] - omega[k - 1]) : 0;
      const double from_above = row + 1 < box.rows ? above[k] * (omega[k + columns] - omega[k]) : 0;
      const double to_below = row > 0 ? above[k - columns] * (omega[k] - omega[k - columns]) : 0;
      circulation[k] += (from_right - to_left) + (from_above - to_below);
    }
  }
  for (const auto& [a, b, conductance] : links) {
    const double passed = conductance * (omega[b] - omega[a]);
    circulation[a] += passed;
    circulation[b] -= passed;
  }
}

/// nu dt/h^2 = 1/6 cancels the leading errors in time and space against each other along an axis,
/// and is stable for the smallest cells, which are half as large as whole ones.
int WallDiffusion::steps(double time) const {
  const double spacing = lattice_->spacing();
  return std::max(1, static_cast<int>(std::ceil(6 * viscosity_ * time / (spacing * spacing))));
}

void WallDiffusion::diffuse(double time, LatticeVorticity& vorticity) const {
  const Coefficients links = coefficients(vorticity.box);
  std::vector<double> omega(vorticity.circulation.size());
  const int count = steps(time);
  for (int n = 0; n < count; ++n)
    links.advance(viscosity_ * time / count, vorticity.circulation, omega);
}

/// All at once, but as late as vorticity from the wall would take to spread to where the particle
/// stands: that has the right second moment.
double WallDiffusion::late_part(int step, int count, const PanelShare& share, double time) const {
  const double delay = share.distance * share.distance / (2 * viscosity_);
  return step == std::lround(std::min(1.0, delay / time) * count) ? 1 : 0;
}

void WallDiffusion::add_sheet(std::span<const double> circulation, double time, Release release,
                              LatticeVorticity& vorticity) const {
  const NodeBox& box = lattice_->box();
  const Coefficients links = coefficients(box);
  std::vector<double> added(box.count()), omega(box.count());
  const int count = steps(time);
  for (int step = 0; step <= count; ++step) {
    if (step > 0) links.advance(viscosity_ * time / count, added, omega);
    for (const PanelShare& share : lattice_->shares())
      added[share.cell] += share.fraction * circulation[share.panel] *
                           (release == Release::evenly ? even_part(step, count)
                                                       : late_part(step, count, share, time));
  }
  for (std::size_t cell = 0; cell < box.count(); ++cell)
    vorticity.circulation[vorticity.box.place(box.i(cell), box.j(cell))] += added[cell];
}

std::vector<double> WallDiffusion::wall_vorticity(std::span<const double> sheet, double time,
                                                  const LatticeVorticity& vorticity) const {
  std::vector<double> result(sheet.size());
  const NodeBox& box = lattice_->box();
  for (const auto& [cell, panel, fraction, distance] : lattice_->shares()) {
    const std::size_t node = vorticity.box.place(box.i(cell), box.j(cell));
    result[panel] += fraction * (vorticity.circulation[node] / lattice_->area(cell) +
                                 distance * sheet[panel] / (viscosity_ * time));
  }
  return result;
}

}  // namespace mote
