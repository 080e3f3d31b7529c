#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "mote/models/incompressible.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// One row a particle of the fluid, one entry a neighbour of the fluid; images are their owners.
template <int D>
void Incompressible<D>::make_pattern() {
  const Index fluids = particles_.fluids();
  const auto& lists = particles_.lists();
  std::size_t longest = 0;
  for (Index i = 0; i < fluids; ++i) longest = std::max(longest, lists[i].size());
  columns_.restart(fluids, longest);
#pragma omp parallel if (parallel_from <= fluids)
  {
    NeighbourLists::Writer writer(columns_);
#pragma omp for schedule(static)
    for (Index i = 0; i < fluids; ++i) {
      Index* const list = writer.room(longest);
      Index* end = list;
      for (const Index j : lists[i])
        if (particles_.is_fluid(j) && particles_.owner(j) != i) *end++ = particles_.owner(j);
      if (!std::is_sorted(list, end)) std::sort(list, end);
      writer.close(i, std::unique(list, end));
    }
  }
  matrix_ = matrix_of_zeros(columns_);
  slot_.assign(weights_.pairs(), -1);
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i) {
    const auto row = row_columns(matrix_, i);
    for (std::size_t k = 0; k < lists[i].size(); ++k) {
      const Index j = lists[i][k];
      if (particles_.is_fluid(j))
        slot_[weights_.first(i) + k] =
            static_cast<Index>(std::ranges::lower_bound(row, particles_.owner(j)) - row.begin());
    }
  }
  pattern_of_ = particles_.rebuilds();
}

/// Solves for the pressure and lets it act.
template <int D>
void Incompressible<D>::project(double step) {
  if (options_.source == PressureSource::density) expect_densities_after(step);
  show(velocity_);
  assemble(step);
  refuse_bad_diagonals();
  solve();
  show_pressure();
  const Index fluids = particles_.fluids();
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i)
    particles_.velocity(i) =
        velocity_[static_cast<std::size_t>(i)] +
        step * (pulls_[static_cast<std::size_t>(i)] - gradient_of_pressure(i) / options_.density);
}

template <int D>
void Incompressible<D>::expect_densities_after(double step) {
  const Index fluids = particles_.fluids();
  auto& lines = particles_.lines();
  const auto move = [&](double duration) {
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
    for (Index i = 0; i < fluids; ++i)
      Vec<D>::Map(lines[static_cast<std::size_t>(i)].value.data() + Line::position) =
          particles_.position(i) + duration * (velocity_[static_cast<std::size_t>(i)] +
                                               step * pulls_[static_cast<std::size_t>(i)]);
    particles_.copy_to_images();
  };
  move(step / 2);
  expected_density_.resize(density_.size());
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i)
    expected_density_[static_cast<std::size_t>(i)] = kernel_density(i) / full_kernel_density_;
  move(0);
}

/// The wanted Laplacian of the pressure over rho/dt, from v in the lines.
template <int D>
double Incompressible<D>::source_at(Index i, double step) const {
  const auto k = static_cast<std::size_t>(i);
  if (options_.source == PressureSource::density)
    return -2 * options_.relaxation * (expected_density_[k] - 1) / step;
  const double deviation = density_[k] - 1;
  const auto& lines = particles_.lines();
  const auto list = particles_.lists()[i];
  const auto weights = weights_.gradient(i);
  const Vec<D> own = lines[k].speed();
  Mat<D> slope = Mat<D>::Zero();
  for (std::size_t n = 0; n < list.size(); ++n)
    slope += weights[n] * (lines[static_cast<std::size_t>(list[n])].speed() - own).transpose();
  double divergence = slope.trace() - step / 2 * (slope * slope).trace();
  if (body_force_.has_formulas())
    for (std::size_t n = 0; n < list.size(); ++n)
      divergence +=
          step *
          weights[n].dot(pulls_[static_cast<std::size_t>(particles_.owner(list[n]))] - pulls_[k]);
  if (options_.source == PressureSource::divergence) return divergence;
  const double left = before_[k];
  return divergence + std::abs(deviation) * left -
         (options_.relaxation + std::abs(step * left)) * deviation / step;
}

/// The negative of the pressure equation, which makes its diagonal positive.
template <int D>
void Incompressible<D>::assemble(double step) {
  const Index fluids = particles_.fluids();
  const auto& lists = particles_.lists();
  const auto& lines = particles_.lines();
  right_side_.assign(static_cast<std::size_t>(fluids), 0);
  pressure_.resize(static_cast<std::size_t>(fluids));
  // Like those of other rows, so that a residual weighs all rows alike in any unit of length.
  const double fixed = 2 * D / (spacing() * spacing());
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto values = row_values(matrix_, i);
    const auto columns = row_columns(matrix_, i);
    const auto own =
        static_cast<std::size_t>(std::ranges::lower_bound(columns, i) - columns.begin());
    std::ranges::fill(values, 0.0);
    if (has_fixed_pressure(i)) {
      values[own] = fixed;
      pressure_[at] = surface_pressure_[at];
      right_side_[at] = fixed * surface_pressure_[at];
      continue;
    }
    pressure_[at] = particles_.pressure(i);
    double right = -options_.density / step * source_at(i, step);
    const auto weights = pressure_laplacian(i);
    const Vec<D> place = lines[at].place();
    for (std::size_t k = 0; k < lists[i].size(); ++k) {
      const Index j = lists[i][k], owner = particles_.owner(j);
      if (owner >= fluids) {
        const Vec<D> pull = pulls_[static_cast<std::size_t>(owner)] -
                            Vec<D>::Map(particles_.motion_of(owner).acceleration.data());
        right += weights[k] * options_.density *
                 pull.dot(lines[static_cast<std::size_t>(j)].place() - place);
        continue;
      }
      values[own] += weights[k];
      if (has_fixed_pressure(owner))
        right += weights[k] * surface_pressure_[static_cast<std::size_t>(owner)];
      else
        values[static_cast<std::size_t>(slot_[weights_.first(i) + k])] -= weights[k];
    }
    if (options_.surface_test == SurfaceTest::missing_neighbours)
      values[own] +=
          2 * std::max(0.0, full_laplacian_ - std::reduce(weights.begin(), weights.end()));
    right_side_[at] = right;
  }
}

/// A diagonal that is not positive would be the solver's to refuse, which knows no particles.
template <int D>
void Incompressible<D>::refuse_bad_diagonals() const {
  const Index fluids = particles_.fluids();
  Index first = fluids;
#pragma omp parallel for schedule(static) reduction(min : first) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i) {
    const auto columns = row_columns(matrix_, i);
    const auto own = std::ranges::lower_bound(columns, i) - columns.begin();
    if (!(row_values(matrix_, i)[static_cast<std::size_t>(own)] > 0)) first = std::min(first, i);
  }
  if (first == fluids) return;
  throw NumericalFailure(
      fmt::format("the Laplacian of particle {} has weights whose sum is not positive",
                  particles_.id(first)),
      {first},
      "its neighbours lie too unevenly for this operator, as at a surface in motion; 'laplacian: "
      "mps', or the operator mps with 'constants: lattice', has positive weights everywhere");
}

template <int D>
void Incompressible<D>::solve() {
  const auto start = std::chrono::steady_clock::now();
  const double level = options_.mean_pressure.value_or(0);
  const bool keeps =
      prepared_for_ == particles_.numberings() && course_.last.iterations <= enough_iterations_;
  course_.last = solver_->solve(matrix_, right_side_, pressure_,
                                keeps ? Preconditioning::kept : Preconditioning::fresh);
  if (!keeps) enough_iterations_ = 2 * course_.last.iterations + 2;
  prepared_for_ = particles_.numberings();
  course_.iterations += course_.last.iterations;
  for (Index i = 0; i < particles_.fluids(); ++i) {
    double& pressure = particles_.pressure(i);
    pressure = pressure_[static_cast<std::size_t>(i)] + level;
    if (!options_.tension) pressure = std::max(0.0, pressure);
  }
  course_.solving +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template class Incompressible<2>;
template class Incompressible<3>;

}  // namespace mote
