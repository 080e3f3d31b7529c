#include "mote/models/vortex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/particles/failure.hpp"
#include "mote/particles/parallel.hpp"

namespace mote {
namespace {

/// Circulation of a periodic box, relative to the sum of magnitudes, that a lattice of finite cells
/// explains, and that is taken away.
constexpr double small_net = 0.01;

}  // namespace

template <int D>
Vortex<D>::Vortex(const VortexOptions& options, SpaceSetup setup)
    : options_(options),
      vortices_(options, setup),
      induced_(induced_velocity<D>({options.sum, options.tolerance, options.core}, setup)),
      diffusion_(vortex_diffusion<D>(options, setup)),
      free_stream_(options.free_stream, setup),
      core_at_start_(vortices_.core_size()) {
  if constexpr (D == 2)
    if (vortices_.has_walls()) bodies_ = std::make_unique<VortexBodies>(options, vortices_);
  if (vortices_.in_a_box()) need_no_net_circulation();
  bind();
  update_dependent_fields();
  learn_from_start();
  complete_fields();
}

template <int D>
void Vortex<D>::learn_from_start() {
  if constexpr (D == 2) {
    const VortexMoments m = moments();
    has_circulation_ = std::abs(m.circulation) > small_net * m.magnitude;
    is_a_pair_ = vortices_.count() == 2 && options_.remesh_every == 0 && !bodies_;
  }
}

template <int D>
void Vortex<D>::bind() {
  circulation_rate_.assign(vortices_.circulation().size(), 0);
  drifted_ = {{vortices_.position(), vortices_.velocity()}};
  kicked_.clear();
  gradient_.assign(D == 3 ? vortices_.position().size() * D : 0, 0);
  if (diffusion_->changes_circulation() || D == 3)
    kicked_.push_back({vortices_.circulation(), circulation_rate_});
}

/// The net circulation of a box must be 0; what there is of it by the cells being finite is taken
/// away in proportion.
template <int D>
void Vortex<D>::need_no_net_circulation() {
  if constexpr (D == 2) {
    const VortexMoments m = moments();
    if (std::abs(m.circulation) > small_net * m.magnitude)
      throw InputError(options_.vortices.empty() ? "initial.vorticity" : "model.vortices",
                       fmt::format("the circulations in a periodic box must add up to 0, and here "
                                   "they come to {:.3g}, {:.3g} of their magnitudes",
                                   m.circulation, std::abs(m.circulation) / m.magnitude));
    for (double& circulation : vortices_.circulation())
      circulation -= std::abs(circulation) * m.circulation / m.magnitude;
  }
}

template <int D>
Sources<D> Vortex<D>::sources() const {
  return {vortices_.position(), vortices_.circulation(), vortices_.core_size()};
}

/// Cores grow during a step as well, at the same rate all the time.
template <int D>
double Vortex<D>::core_size_at(double time) const {
  const double growth = diffusion_->core_growth();
  if (growth == 0) return core_at_start_;
  return std::sqrt(core_at_start_ * core_at_start_ + growth * (time - time_));
}

/// Velocities are not summed again for the state that they are of, which is that at the start of a
/// step.
template <int D>
void Vortex<D>::update_drift_rates(double time) {
  if (diffusion_->core_growth() > 0) vortices_.spread_cores(core_size_at(time));
  const bool known = summed_.time == time && summed_.core_size == vortices_.core_size() &&
                     std::ranges::equal(summed_.position, vortices_.position()) &&
                     std::ranges::equal(summed_.circulation, vortices_.circulation());
  if (known) return;
  induced_->at_sources(sources(), {vortices_.velocity(), gradient_});
  ++evaluations_;
  free_stream_.add(vortices_.position(), time, vortices_.velocity());
  if constexpr (D == 3) free_stream_.add_gradient(vortices_.position(), time, gradient_);
  if constexpr (D == 2)
    if (bodies_) bodies_->add_velocity(vortices_, time, vortices_.velocity());
  summed_.time = time;
  summed_.core_size = vortices_.core_size();
  summed_.position.assign(vortices_.position().begin(), vortices_.position().end());
  summed_.circulation.assign(vortices_.circulation().begin(), vortices_.circulation().end());
}

template <int D>
void Vortex<D>::update_kick_rates(double time) {
  if (kicked_.empty()) return;
  diffusion_->find_rates(vortices_, circulation_rate_);
  if constexpr (D == 3) {
    update_drift_rates(time);  // for the gradient
    add_stretching();
  }
}

template <int D>
void Vortex<D>::add_stretching() {
  using Slope = Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>;
  const bool transposed = options_.stretches_as(Stretching::transposed);
  const bool alone = !diffusion_->changes_circulation();
  const auto circulation = vortices_.circulation();
#pragma omp parallel for schedule(static) if (parallel_from <= vortices_.count())
  for (Index i = 0; i < vortices_.count(); ++i) {
    const std::ptrdiff_t first = std::ptrdiff_t{i} * D;
    const Slope slope(gradient_.data() + first * D);
    const Vec<D> alpha = Vec<D>::Map(circulation.data() + first);
    auto rate = Vec<D>::Map(circulation_rate_.data() + first);
    if (alone) rate.setZero();
    rate += transposed ? Vec<D>(slope.transpose() * alpha) : Vec<D>(slope * alpha);
  }
}

template <int D>
void Vortex<D>::begin_step(double time, double step) {
  time_ = time;
  core_at_start_ = vortices_.core_size();
  if constexpr (D == 2)
    if (bodies_) bodies_->begin_step(vortices_, time, step);
}

template <int D>
void Vortex<D>::end_step(double time, double step) {
  if (bodies_) return end_step_beside_walls(time, step);
  vortices_.spread_cores(core_size_at(time + step));
  time_ = time + step;
  core_at_start_ = vortices_.core_size();
  diffusion_->end_step(vortices_, time, step);
  vortices_.wrap();
  inspect();
  if (options_.remesh_every > 0) grow_older();
}

template <int D>
void Vortex<D>::grow_older() {
  for (double& age : vortices_.age()) ++age;
  if (vortices_.age().front() >= options_.remesh_every) remesh();
}

template <int D>
void Vortex<D>::end_step_beside_walls(double time, double step) {
  inspect();
  if constexpr (D == 2) bodies_->end_step(vortices_, time, step);
  time_ = time + step;
  bind();
}

template <int D>
VortexLatticeOptions Vortex<D>::lattice() const {
  const SpaceStart& start = vortices_.start();
  VortexLatticeOptions lattice{start.spacing, start.lower, {}, options_.threshold};
  for (std::size_t d = 0; d < D && vortices_.in_a_box(); ++d)
    lattice.cells[d] =
        static_cast<Index>(std::lround((start.upper[d] - start.lower[d]) / start.spacing));
  return lattice;
}

template <int D>
void Vortex<D>::remesh() {
  VortexList<D> before;
  before.position.assign(vortices_.position().begin(), vortices_.position().end());
  before.circulation.assign(vortices_.circulation().begin(), vortices_.circulation().end());
  RemeshingLoss loss;
  if (options_.remeshing == Remeshing::gauss) {
    const double first = options_.core_radius(spacing()), now = vortices_.core_size();
    const double deviation = std::sqrt(std::max(0.0, now * now - first * first));
    if (deviation < least_deviation * spacing()) return;
    vortices_.replace(spread_on_lattice(before, lattice(), deviation, &loss));
    vortices_.spread_cores(first);
    core_at_start_ = first;
  } else {
    vortices_.replace(remeshed(before, lattice(), &loss));
  }
  bind();
  ++course_.remeshings;
  course_.dropped = std::max(course_.dropped, loss.dropped);
}

/// Friction may change sizes and places beside the values that a path goes through, and a box takes
/// places back into itself.
template <int D>
bool Vortex<D>::has_paths() const {
  return compensates() && options_.kinematic_viscosity == 0 && !vortices_.in_a_box();
}

template <int D>
void Vortex<D>::stand_at(double time) {
  time_ = time;
  update_dependent_fields();
}

template <int D>
void Vortex<D>::update_dependent_fields() {
  update_drift_rates(time_);
}

/// The vorticity of the blobs, cores and all; of points, and beside walls, where cores would reach
/// into the bodies, their circulation over their volume.
template <int D>
void Vortex<D>::complete_fields() {
  if (options_.core != "point" && !bodies_)
    return induced_->vorticity_at_sources(sources(), vortices_.vorticity());
  for (std::size_t k = 0; k < vortices_.vorticity().size(); ++k)
    vortices_.vorticity()[k] = vortices_.density(k / vortices_.strengths, k % vortices_.strengths);
}

template <int D>
void Vortex<D>::inspect() const {
  for (Index i = 0; i < vortices_.count(); ++i)
    if (!vortices_.place(i).allFinite() ||
        !std::isfinite(vortices_.strength(static_cast<std::size_t>(i))))
      throw NumericalFailure(
          fmt::format("vortex {} has a place or a circulation that is not finite", i), {i},
          "the step is too long");
}

template <int D>
void Vortex<D>::restore(const Cloud& state) {
  vortices_.restore(state);
  core_at_start_ = vortices_.core_size();
  summed_.core_size = -1;
  bind();
}

template <int D>
std::vector<StepLimit> Vortex<D>::step_limits() {
  const double longest = diffusion_->longest_step();
  if (std::isinf(longest)) return {};
  return {{longest,
           "diffusion by exchange, range^2/(2 nu), is unstable with forward_euler beyond "
           "it, and with runge_kutta_4 from 1.4 times as long on",
           true}};
}

/// A part of the time in which the strongest vortex turns by one radian, and no more than what
/// diffusion allows.
template <int D>
double Vortex<D>::longest_step(double /*time*/, double courant) {
  return std::min(courant / vortices_.highest_density(), diffusion_->longest_step());
}

template class Vortex<2>;
template class Vortex<3>;

}  // namespace mote
