#include <Eigen/Eigenvalues>
#include <algorithm>

#include "mote/models/weakly_compressible.hpp"

namespace mote {
namespace {

/// Below this the smallest eigenvalue of the moment of a particle's neighbours tells that it is
/// near a free surface, or at one (Marrone et al. 2010).
constexpr double near_surface = 0.75, at_surface = 0.2;

/// From near_surface to this the shift across the surface grows from none to all of it.
constexpr double inside = 0.95;

template <int D>
double smallest_eigenvalue(const Mat<D>& moment) {
  return Eigen::SelfAdjointEigenSolver<Mat<D>>(moment, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

}  // namespace

template <int D>
FluidSpread<D> WeaklyCompressible<D>::spread_of(Index i) const {
  const ClosePairs close_pairs{start_.spacing, options_.free_surface ? ClosePairs().weight : 0};
  return terms_->spread(lines_, i, neighbours_.lists()[i], smoothing_length_, mass_, close_pairs);
}

/// Brings the lines up to date with the state.
template <int D>
void WeaklyCompressible<D>::refresh_lines(double time) {
  if (!lists_are_current_) {
    find_neighbours();
    lists_are_current_ = false;
  }
  observe_walls(time);
  write_fluid_lines(0);
  write_image_lines();
  if (options_.walls == WallForm::extrapolated) write_wall_lines();
}

/// The change of a particle's density by a shift, beside that along the density's gradient. Density
/// that is carried in pairs grows as particles crowd, and a shift, which undoes that, has to take
/// it back; else it grows for ever where a fluid is stirred. Sun et al. (2019) add to D rho/Dt, for
/// the velocity w of the shift,
///   -rho_i sum V_j (w_j - w_i).grad W + sum V_j (rho_i w_i + rho_j w_j).grad W,
/// which is  2 rho_i w_i.(sum V_j grad W) + sum V_j (rho_j - rho_i) w_j.grad W, the first of them
/// this one. With a free surface it is left out, as theirs is near one: there sum V_j grad W is not
/// 0 however particles lie.
template <int D>
double WeaklyCompressible<D>::change_by_shift(const FluidSpread<D>& spread, double density,
                                              const Vec<D>& shift) const {
  if (options_.free_surface || !coefficients_.continuity) return 0;
  return 2 * density * shift.dot(spread.crowding);
}

/// Moves the fluid a little from where its particles crowd to where they are few, which keeps sums
/// over neighbours good (Sun et al. 2017, (10)):
///   delta x_i = -4 h U dt sum V_j (1 + 0.2 (W_ij/W(dx))^4) grad W,
/// no further than a tenth of a spacing, and carries velocity and density along their gradients to
/// the new places. What the fluid's momentum gains by that is taken from all that moved alike, so
/// that it is kept. Particles near a free surface stay where they are, and the next ones move along
/// it alone: across it they would crowd into the outermost layer, where neighbours are always few.
/// Its normal is the direction in which neighbours are fewest, the first eigenvector of the moment.
/// The term of close pairs keeps particles from clumping under tension. Without a free surface it
/// is left out: a uniform pressure pulls particles to where sum V_j grad W is 0, and a shift that
/// comes to rest elsewhere works against it for ever, which brakes the flow.
template <int D>
void WeaklyCompressible<D>::shift_particles(double time, double step) {
  refresh_lines(time);
  const double strength = options_.shifting * 4 * smoothing_length_ * highest_speed_ * step;
  const double limit = 0.1 * start_.spacing;
  gains_.assign(static_cast<std::size_t>(cloud_.count()), Vec<D>::Zero());
  moves_.assign(gains_.size(), 0);
  double furthest = 0;
#pragma omp parallel for schedule(dynamic, 256) \
    reduction(max                               \
              : furthest) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i) {
    if (is_wall(i)) continue;
    const FluidSpread<D> spread = spread_of(i);
    Vec<D> shift = -strength * spread.crowding;
    if (options_.free_surface) {
      Eigen::SelfAdjointEigenSolver<Mat<D>> eigen;
      eigen.computeDirect(spread.moment);
      const double least = eigen.eigenvalues()[0];
      if (least < near_surface) continue;
      const Vec<D> normal = eigen.eigenvectors().col(0);
      const double part = std::min(1.0, (least - near_surface) / (inside - near_surface));
      shift -= (1 - part) * shift.dot(normal) * normal;
    }
    if (shift.norm() > limit) shift *= limit / shift.norm();
    furthest = std::max(furthest, shift.norm());
    const Mat<D> inverse = spread.moment.inverse();
    Vec<D>::Map(position_.data() + std::ptrdiff_t{i} * D) += shift;
    gains_[static_cast<std::size_t>(i)] = spread.velocity * inverse * shift;
    moves_[static_cast<std::size_t>(i)] = 1;
    if (options_.density_form == FluidDensity::continuity)
      density_[i] +=
          spread.density.dot(inverse * shift) + change_by_shift(spread, density_[i], shift);
  }
  furthest_shift_ = furthest;
  Vec<D> mean = Vec<D>::Zero();
  for (const Vec<D>& gain : gains_) mean += gain;
  mean /= std::max<double>(1, static_cast<double>(std::ranges::count(moves_, 1)));
#pragma omp parallel for schedule(static) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i)
    if (moves_[static_cast<std::size_t>(i)] != 0)
      Vec<D>::Map(velocity_.data() + std::ptrdiff_t{i} * D) +=
          gains_[static_cast<std::size_t>(i)] - mean;
}

/// What makes the density diffusion leave linear densities alone (Antuono et al. 2010): where that
/// of FluidTerms has 2 (rho_j - rho_i), theirs has
///   2 (rho_j - rho_i) - (<grad rho>_i + <grad rho>_j).(x_j - x_i),
/// which adds  +delta h c sum V_j (<grad rho>_i + <grad rho>_j).(x_j - x_i) F_ij.
template <int D>
void WeaklyCompressible<D>::add_density_correction() {
  if (options_.diffusion != DensityDiffusion::antuono || coefficients_.diffusion == 0) return;
  slopes_.resize(lines_.size());
#pragma omp parallel for schedule(dynamic, 256) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i) {
    slopes_[static_cast<std::size_t>(i)] = Vec<D>::Zero();
    if (is_wall(i)) continue;
    const FluidSpread<D> spread = spread_of(i);
    if (smallest_eigenvalue<D>(spread.moment) > at_surface)
      slopes_[static_cast<std::size_t>(i)] = spread.moment.inverse() * spread.density;
  }
  copy_slopes_to_images();
  continue_slopes_into_walls();
  copy_slopes_to_images();
#pragma omp parallel for schedule(dynamic, 256) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i)
    if (!is_wall(i) || options_.walls == WallForm::dynamic) {
      const auto k = static_cast<std::size_t>(i);
      const double added =
          terms_->linear_diffusion(lines_, i, neighbours_.lists()[i], smoothing_length_, slopes_);
      const double volume = lines_[k].value[Line::volume];
      sums_[k].value[PairSums::rate] += coefficients_.diffusion * volume / mass_ * added;
    }
}

template <int D>
void WeaklyCompressible<D>::copy_slopes_to_images() {
  const auto images = neighbours_.images();
  for (std::size_t k = 0; k < images.size(); ++k)
    slopes_[static_cast<std::size_t>(cloud_.count()) + k] =
        slopes_[static_cast<std::size_t>(images[k].owner)];
}

/// Walls take the mean slope of the fluid within the kernel's support, whatever else is listed:
/// with none, half of what a linear density diffuses across the wall would be left.
template <int D>
void WeaklyCompressible<D>::continue_slopes_into_walls() {
  const auto& lists = neighbours_.lists();
  const double support = terms_->support() * smoothing_length_ * rim_tolerance;
#pragma omp parallel for schedule(dynamic, 256) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i) {
    if (!is_wall(i)) continue;
    const Vec<D> place = lines_[static_cast<std::size_t>(i)].place();
    Vec<D> sum = Vec<D>::Zero();
    double fluids = 0;
    for (const Index j : lists[i]) {
      if ((place - lines_[static_cast<std::size_t>(j)].place()).norm() > support) continue;
      sum += slopes_[static_cast<std::size_t>(j)];
      ++fluids;
    }
    if (fluids > 0) slopes_[static_cast<std::size_t>(i)] = sum / fluids;
  }
}

/// Pressure everywhere.
template <int D>
void WeaklyCompressible<D>::complete_fields() {
  refresh_lines(now_);
#pragma omp parallel for schedule(static) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i)
    pressure_[i] = lines_[static_cast<std::size_t>(i)].value[Line::pressure];
}

/// Where the free surface is, which takes all neighbours of a particle.
template <int D>
void WeaklyCompressible<D>::complete_snapshot() {
  complete_fields();
  if (!options_.free_surface) return;
  if (!needs_all_neighbours()) {
    find_neighbours(ListForm::ascending);
    refresh_lines(now_);
    lists_are_current_ = false;
  }
#pragma omp parallel for schedule(dynamic, 256) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i)
    surface_[i] = is_wall(i) ? 0 : smallest_eigenvalue<D>(spread_of(i).moment) < near_surface;
}

template class WeaklyCompressible<2>;
template class WeaklyCompressible<3>;

}  // namespace mote
