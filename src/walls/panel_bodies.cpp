#include "mote/walls/panel_bodies.hpp"

#include <fmt/format.h>

#include "mote/particles/failure.hpp"

namespace mote {

PanelBodies::PanelBodies(std::span<const Outline> bodies, double panel_length) : first_panel_{0} {
  for (const Outline& body : bodies) {
    const std::vector<Panel> panels = panels_of(body, panel_length);
    panels_.insert(panels_.end(), panels.begin(), panels.end());
    first_panel_.push_back(panels_.size());
  }
  if (panels_.size() > most_panels)
    throw InputError(
        fmt::format("the bodies have {} panels; a dense matrix is for at most {}: "
                    "make the panels longer",
                    panels_.size(), most_panels));
  factors_.compute(equations());
}

std::span<const Panel> PanelBodies::panels(std::size_t body) const {
  return panels().subspan(first_panel_[body], first_panel_[body + 1] - first_panel_[body]);
}

/// A row for every panel and one for every body's circulation. As the rows of a body sum to 0, each
/// body has one more unknown, a velocity along its surface: 0 when the right-hand side sums to 0.
Eigen::MatrixXd PanelBodies::equations() const {
  const auto count = static_cast<Eigen::Index>(panels_.size());
  const auto bodies = static_cast<Eigen::Index>(body_count());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + bodies, count + bodies);
#pragma omp parallel for schedule(static)
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < count; ++i)
      matrix(i, j) =
          i == j ? -panels_[i].length() / 2 : circulation_of_sheet(panels_[i], panels_[j]);
  for (Eigen::Index body = 0; body < bodies; ++body)
    for (std::size_t k = first_panel_[body]; k < first_panel_[body + 1]; ++k)
      matrix(k, count + body) = matrix(count + body, k) = panels_[k].length();
  return matrix;
}

std::vector<double> PanelBodies::circulation_along_panels(Complex stream,
                                                          const Vortices& vortices) const {
  std::vector<double> result;
  for (const Panel& panel : panels_)
    result.push_back((std::conj(stream) * (panel.to - panel.from)).real());
  add_circulations(panels_, vortices, result);
  return result;
}

std::vector<double> PanelBodies::sheet(std::span<const double> along_panels,
                                       std::span<const double> circulation) const {
  Eigen::VectorXd right(static_cast<Eigen::Index>(panels_.size() + body_count()));
  for (std::size_t i = 0; i < panels_.size(); ++i) right[i] = -along_panels[i];
  for (std::size_t b = 0; b < body_count(); ++b) right[panels_.size() + b] = circulation[b];
  const Eigen::VectorXd solution = factors_.solve(right);
  return {solution.begin(), solution.begin() + static_cast<Eigen::Index>(panels_.size())};
}

void PanelBodies::add_velocity(std::span<const double> sheet, std::span<const Complex> places,
                               std::span<Complex> velocity) const {
  add_sheet_velocities(panels_, sheet, places, velocity);
}

double PanelBodies::circulation(std::span<const double> sheet, std::size_t body) const {
  double sum = 0;
  for (std::size_t k = first_panel_[body]; k < first_panel_[body + 1]; ++k)
    sum += sheet[k] * panels_[k].length();
  return sum;
}

}  // namespace mote
