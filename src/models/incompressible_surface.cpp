#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mote/models/incompressible.hpp"
#include "mote/operators/differential/mps.hpp"
#include "mote/operators/weights/lattice_sum.hpp"
#include "mote/operators/weights/reciprocal.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// Below this number density, in n0, or where neighbours spread less than this in some direction, a
/// particle at the surface is alone: it has too few neighbours for derivatives. From there on the
/// trust in its pressure gradient grows, up to a neighbourhood that is round enough.
constexpr double few = 0.3, flat = 0.1, round = 0.3;

/// Weight of a neighbour at a distance in spacings.
double counting_weight(double distance) { return Reciprocal::value(distance / counted_within); }

}  // namespace

/// n0, and the kernel's sum, of a lattice: what a particle well inside the fluid has.
template <int D>
void Incompressible<D>::find_full_neighbourhood() {
  full_number_density_ = lattice_sum<D>(counted_within, counting_weight);
  full_kernel_density_ = lattice_kernel_density();
  find_full_laplacian();
  refuse_broken_arrangement();
  particles_.forget_neighbours();
}

/// The kernel's sum over a lattice with this spacing, around one of its points.
template <int D>
double Incompressible<D>::lattice_kernel_density() const {
  const int layers = static_cast<int>(particles_.reach() / spacing()) + 1, side = 2 * layers + 1;
  std::vector<Line> lattice(static_cast<std::size_t>(std::pow(side, D) + 0.5));
  std::vector<Index> others;
  Index centre = 0;
  for (Index k = 0; k < static_cast<Index>(lattice.size()); ++k) {
    Line& line = lattice[static_cast<std::size_t>(k)];
    Vec<D> place;
    for (Index d = 0, rest = k; d < D; ++d, rest /= side) place[d] = rest % side - layers;
    Vec<D>::Map(line.value.data() + Line::position) = spacing() * place;
    line.value[Line::volume] = volume_;
    if (place.isZero(0))
      centre = k;
    else
      others.push_back(k);
  }
  return terms_->density(lattice, centre, others, smoothing_length_, mass_);
}

/// What the fluid is like at the start: the lattice's n0 and lambda0 must be its own, and the level
/// of the pressure fixed by its surface, or else it must have none.
template <int D>
void Incompressible<D>::refuse_broken_arrangement() {
  // A lattice with a plane surface has 0.68 there, in space 0.73, and disorder seldom less than
  // 0.75.
  constexpr double broken = 0.2, one_sided = D == 2 ? 0.7 : 0.74;
  find_surroundings(0, 0);
  double sum = 0, whole = 0;
  for (Index i = 0; i < particles_.fluids(); ++i) {
    const double n = number_density(i) / full_number_density_;
    if (!options_.free_surface && n < one_sided)
      throw InputError("model.free_surface",
                       fmt::format("particle {} has {:.2g} of the neighbours that it has inside a "
                                   "fluid: is it at a free surface?",
                                   particles_.id(i), n));
    if (n < options_.surface_threshold) continue;
    sum += density_[static_cast<std::size_t>(i)];
    ++whole;
  }
  if (whole == 0)
    throw InputError("particles",
                     "no particle is well inside the fluid: all have too few "
                     "neighbours for n0 to be their number density");
  if (std::abs(sum / whole - 1) > broken)
    throw InputError("particles",
                     fmt::format("n0 is that of a lattice, and the particles well inside the fluid "
                                 "lie {:.3g} times as densely",
                                 sum / whole));
  before_.assign(density_.size(), 0);
  note_fields();
  if (options_.free_surface && std::ranges::count(at_surface_, 1) == 0)
    throw InputError("model.free_surface",
                     "no particle is at a free surface, and nothing else fixes the level of the "
                     "pressure: 'free_surface: false' and 'mean_pressure' are needed");
}

/// The sum of l_ij of mps on a lattice, 2 D/lambda0.
template <int D>
void Incompressible<D>::find_full_laplacian() {
  if (options_.surface_test != SurfaceTest::missing_neighbours) return;
  const auto* mps =
      dynamic_cast<const Mps<D>*>(pressure_operator_ ? pressure_operator_.get() : operator_.get());
  if (mps == nullptr || mps->constants != MpsConstants::lattice)
    throw InputError("model.surface.test",
                     "'missing_neighbours' needs 'laplacian: mps', or the operator mps with "
                     "'constants: lattice'");
  full_laplacian_ = 2 * D / (mps->lattice_lambda() * spacing() * spacing());
}

template <int D>
double Incompressible<D>::number_density(Index i) const {
  const auto& lines = particles_.lines();
  const Vec<D> own = lines[static_cast<std::size_t>(i)].place();
  const double furthest = std::pow(counted_within * spacing(), 2) * rim_tolerance;
  double sum = 0;
  for (const Index j : particles_.lists()[i]) {
    const double squared = (lines[static_cast<std::size_t>(j)].place() - own).squaredNorm();
    if (squared < furthest) sum += counting_weight(std::sqrt(squared) / spacing());
  }
  return sum;
}

/// Smallest eigenvalue of D/n0 sum w e e^T, e the directions to the neighbours: 1 well inside, 0
/// where they lie in a plane.
template <int D>
double Incompressible<D>::least_spread(Index i) const {
  const auto& lines = particles_.lines();
  const Vec<D> own = lines[static_cast<std::size_t>(i)].place();
  Mat<D> sum = Mat<D>::Zero();
  for (const Index j : particles_.lists()[i]) {
    const Vec<D> x = lines[static_cast<std::size_t>(j)].place() - own;
    sum += counting_weight(x.norm() / spacing()) / x.squaredNorm() * x * x.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat<D>> eigen(sum, Eigen::EigenvaluesOnly);
  return D * eigen.eigenvalues()[0] / full_number_density_;
}

template <int D>
double Incompressible<D>::kernel_density(Index i) const {
  return terms_->density(particles_.lines(), i, particles_.lists()[i], smoothing_length_, mass_);
}

template <int D>
void Incompressible<D>::find_surface() {
  const Index fluids = particles_.fluids();
  at_surface_.assign(static_cast<std::size_t>(fluids), 0);
  alone_.assign(at_surface_.size(), 0);
  density_.assign(at_surface_.size(), 1);
  trust_.assign(at_surface_.size(), 1);
  surface_pressure_.assign(at_surface_.size(), 0);
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i) {
    const auto k = static_cast<std::size_t>(i);
    density_[k] = kernel_density(i) / full_kernel_density_;
    if (!options_.free_surface) continue;
    const double n = number_density(i) / full_number_density_;
    const bool cone = options_.surface_test == SurfaceTest::cone;
    at_surface_[k] = n < few || (cone ? has_empty_cone(i) : n < options_.surface_threshold);
    if (at_surface_[k] == 0 || options_.surface_test == SurfaceTest::missing_neighbours) continue;
    trust_[k] = std::clamp((least_spread(i) - flat) / (round - flat), 0.0, 1.0);
    alone_[k] = n < few || trust_[k] == 0;
    if (alone_[k] == 0) surface_pressure_[k] = pressure_half_a_spacing_down(i);
  }
}

/// Pressure at the centre of a particle at the surface: the weight of the half of it that is above.
/// All of it where the surface faces up within 48 degrees, so that level surfaces have one pressure
/// however their outlines are seen near walls.
template <int D>
double Incompressible<D>::pressure_half_a_spacing_down(Index i) const {
  const double upward = -gravity().dot(outward(i).normalized());
  return options_.density * spacing() / 2 * std::clamp(1.5 * upward, 0.0, gravity().norm());
}

/// Away from where the neighbours are. [length]
template <int D>
Vec<D> Incompressible<D>::outward(Index i) const {
  const auto& lines = particles_.lines();
  Vec<D> sum = Vec<D>::Zero();
  for (const Index j : particles_.lists()[i]) {
    const Vec<D> x =
        lines[static_cast<std::size_t>(j)].place() - lines[static_cast<std::size_t>(i)].place();
    const double rest = std::max(0.0, 1 - x.norm() / particles_.reach());
    sum -= rest * rest * x;
  }
  return sum;
}

/// The test of Marrone et al. (2010): no neighbour within 45 degrees of the outward normal up to
/// the distance sqrt(2) s, nor beyond that within s of the point at s along the normal; s is the
/// cone_length.
template <int D>
bool Incompressible<D>::has_empty_cone(Index i) const {
  const auto& lines = particles_.lines();
  const Vec<D> own = lines[static_cast<std::size_t>(i)].place();
  const double s = cone_length * spacing();
  Vec<D> normal = outward(i);
  if (normal.norm() < 1e-3 * spacing()) return particles_.lists()[i].empty();
  normal.normalize();
  return std::ranges::none_of(particles_.lists()[i], [&](Index j) {
    const Vec<D> x = lines[static_cast<std::size_t>(j)].place() - own;
    if (x.norm() >= std::sqrt(2.0) * s) return (x - s * normal).norm() < s;
    return x.dot(normal) > std::sqrt(0.5) * x.norm();
  });
}

/// Moves the fluid a little from where its particles crowd to where they are few, and carries the
/// velocity along its gradient: Sun et al. (2017), (10), as for the weakly compressible fluid. What
/// the momentum gains by that is taken from all that moved alike. Near a free surface particles
/// stay where they are.
template <int D>
void Incompressible<D>::shift_particles(double time, double step) {
  const double strength = options_.shifting * 4 * smoothing_length_ * highest_speed() * step;
  const double limit = 0.1 * spacing();
  particles_.update_neighbours(time, 2 * step * highest_speed());
  const Index fluids = particles_.fluids();
  show_velocities();
  Vectors& gains = velocity_;
  moves_.assign(gains.size(), 0);
#pragma omp parallel for schedule(dynamic, 256) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i) {
    const auto k = static_cast<std::size_t>(i);
    gains[k].setZero();
    const FluidSpread<D> spread = terms_->spread(particles_.lines(), i, particles_.lists()[i],
                                                 smoothing_length_, mass_, {spacing()});
    constexpr double near_surface = 0.75;
    const Eigen::SelfAdjointEigenSolver<Mat<D>> eigen(spread.moment, Eigen::EigenvaluesOnly);
    if (options_.free_surface && eigen.eigenvalues()[0] < near_surface) continue;
    Vec<D> shift = -strength * spread.crowding;
    if (shift.norm() > limit) shift *= limit / shift.norm();
    particles_.position(i) += shift;
    gains[k] = spread.velocity * spread.moment.inverse() * shift;
    moves_[k] = 1;
  }
  Vec<D> mean = Vec<D>::Zero();
  for (const Vec<D>& gain : gains) mean += gain;
  mean /= std::max<double>(1, static_cast<double>(std::ranges::count(moves_, 1)));
  for (Index i = 0; i < fluids; ++i)
    if (moves_[static_cast<std::size_t>(i)] != 0)
      particles_.velocity(i) += gains[static_cast<std::size_t>(i)] - mean;
}

template class Incompressible<2>;
template class Incompressible<3>;

}  // namespace mote
