#include "mote/xivas/particle_fields.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <exception>

#include "mote/particles/failure.hpp"
#include "mote/particles/parallel.hpp"
#include "mote/xivas/box_points.hpp"
#include "mote/xivas/projection.hpp"

namespace mote {
namespace {

/// Sides of the cells of a mesh, in mean distances of particles: about a point of the mesh there
/// are twelve of them in the plane and thirty in space, enough for a linear function among
/// strangers.
constexpr double coarseness = 2;

/// How much further than the fastest particle goes straight on the mesh reaches.
constexpr double reserve = 1.5;

template <int D>
auto vectors_of(std::span<const double> numbers) {
  return Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>>(
      numbers.data(), D, static_cast<Eigen::Index>(numbers.size() / D));
}

template <int D>
MovingParticles without_bad_numbers(MovingParticles particles) {
  for (const auto* vectors : {&particles.position, &particles.velocity, &particles.acceleration})
    if (!vectors_of<D>(*vectors).allFinite())
      throw NumericalFailure("a place, velocity or acceleration of a particle is not finite", {},
                             "the step is too long");
  return particles;
}

/// The box of the particles and as far beyond as they may go, but no further than half its longest
/// side, so that what turns about its middle stays inside. There is room for a cell at least.
template <int D>
MeshBox<D> box_about(const MovingParticles& particles, double step) {
  const auto places = vectors_of<D>(particles.position);
  const MeshBox<D> box{places.rowwise().minCoeff(), places.rowwise().maxCoeff()};
  const double travel = step * vectors_of<D>(particles.velocity).colwise().norm().maxCoeff();
  const double side = (box.upper - box.lower).maxCoeff();
  const double longest = side > 0 || travel > 0 ? std::max(side, travel) : 1;
  const double apart = longest / std::pow(static_cast<double>(places.cols()), 1.0 / D);
  const double margin = std::min(reserve * travel, longest / 2) + apart;
  return {box.lower.array() - margin, box.upper.array() + margin};
}

template <int D>
std::vector<double> points_of(const MeshBox<D>& box, Index particles) {
  const double volume = (box.upper - box.lower).prod() / particles;
  return points_in_box<D>(box.lower, box.upper,
                          {.spacing = coarseness * std::pow(volume, 1.0 / D)});
}

}  // namespace

/// With m = (1, (x - c)/s), coefficients C that minimise the sum of |C m - u|^2, of which places on
/// one line leave some open: those are 0.
template <int D>
LinearFit<D>::LinearFit(std::span<const double> places, std::span<const double> vectors) {
  using Moments = Eigen::Matrix<double, D + 1, D + 1>;
  constexpr double singular = 1e-12;
  const auto x = vectors_of<D>(places);
  centre_ = x.rowwise().mean();
  const double size = (x.colwise() - centre_).cwiseAbs().maxCoeff();
  if (size > 0) scale_ = size;
  Moments moments = Moments::Zero();
  coefficients_.setZero();
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const auto m =
        (Eigen::Matrix<double, D + 1, 1>() << 1, (x.col(i) - centre_) / scale_).finished();
    moments += m * m.transpose();
    coefficients_ += vectors_of<D>(vectors).col(i) * m.transpose();
  }
  Eigen::FullPivLU<Moments> factors;
  factors.setThreshold(singular).compute(moments);
  coefficients_ = factors.solve(coefficients_.transpose()).transpose().eval();
}

template <int D>
Vec<D> LinearFit<D>::at(const Vec<D>& place) const {
  return coefficients_.col(0) + coefficients_.template rightCols<D>() * (place - centre_) / scale_;
}

template <int D>
ParticleFields<D>::ParticleFields(MovingParticles particles, const std::array<double, 3>& periods,
                                  double step)
    : particles_(without_bad_numbers<D>(std::move(particles))),
      count_(static_cast<Index>(particles_.position.size() / D)),
      step_(step),
      box_(box_about<D>(particles_, step)),
      mesh_(points_of<D>(box_, count_)),
      streamlines_(NodalField<D>(mesh_, {})) {
  for (int axis = 0; axis < D; ++axis)
    if (periods[static_cast<std::size_t>(axis)] > 0)
      add_images(axis, periods[static_cast<std::size_t>(axis)]);
  cells_ = cells_of_particles();
  const Projection<D> projection(mesh_, particles_.position, cells_, ProjectionKind::least_squares);
  velocity_ = project(projection, particles_.velocity);
  acceleration_ = project(projection, particles_.acceleration);
  streamlines_ =
      Streamlines<D>(NodalField<D>(mesh_, velocity_), NodalField<D>(mesh_, acceleration_));
}

/// Of all particles so far that have one in the box along this axis.
template <int D>
void ParticleFields<D>::add_images(int axis, double period) {
  const std::size_t so_far = particles_.position.size();
  for (std::size_t first = 0; first < so_far; first += D)
    for (const double shift : {-period, period}) {
      const double place = particles_.position[first + static_cast<std::size_t>(axis)] + shift;
      if (place < box_.lower[axis] || place > box_.upper[axis]) continue;
      for (auto* vectors : {&particles_.position, &particles_.velocity, &particles_.acceleration})
        for (std::size_t d = 0; d < D; ++d) vectors->push_back((*vectors)[first + d]);
      particles_.position[particles_.position.size() - D + static_cast<std::size_t>(axis)] = place;
    }
}

/// Each is looked for from where the one before it is.
template <int D>
std::vector<Index> ParticleFields<D>::cells_of_particles() const {
  const auto places = vectors_of<D>(particles_.position);
  std::vector<Index> cells;
  for (const auto& place : places.colwise())
    cells.push_back(mesh_.locate(place, cells.empty() ? 0 : cells.back()));
  return cells;
}

template <int D>
std::vector<double> ParticleFields<D>::project(const Projection<D>& projection,
                                               std::vector<double> vectors) const {
  const LinearFit<D> linear(particles_.position, vectors);
  for (std::size_t first = 0; first < vectors.size(); first += D)
    Vec<D>::Map(&vectors[first]) -= linear.at(Vec<D>::Map(&particles_.position[first]));
  std::vector<double> projected = projection.project(vectors);
  for (Index point = 0; point < mesh_.point_count(); ++point)
    Vec<D>::Map(projected.data() + std::ptrdiff_t{point} * D) += linear.at(mesh_.point(point));
  return projected;
}

template <int D>
std::vector<OwnMotion<D>> ParticleFields<D>::mean_motions() const {
  std::vector<OwnMotion<D>> motions(static_cast<std::size_t>(count_));
  std::vector<std::exception_ptr> failures(motions.size());
#pragma omp parallel for schedule(dynamic, 64) if (count_ >= parallel_from)
  for (Index i = 0; i < count_; ++i) try {
      motions[static_cast<std::size_t>(i)] = mean_motion(i);
    } catch (...) {
      failures[static_cast<std::size_t>(i)] = std::current_exception();
    }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return motions;
}

template <int D>
OwnMotion<D> ParticleFields<D>::mean_motion(Index i) const {
  const Vec<D> place = vectors_of<D>(particles_.position).col(i);
  const Passage<D> start{.position = place, .cell = cells_[static_cast<std::size_t>(i)]};
  const OwnMotion<D> own{
      vectors_of<D>(particles_.velocity).col(i) - streamlines_.velocity(start),
      vectors_of<D>(particles_.acceleration).col(i) - streamlines_.acceleration(start)};
  const Passage<D> end = streamlines_.follow(place, start.cell, step_, own);
  const double beyond = end.left ? end.time.lacks(step_) : 0;
  return {(end.position - place + beyond * streamlines_.velocity(end)) / step_,
          (end.gain + beyond * streamlines_.acceleration(end)) / step_};
}

template class LinearFit<2>;
template class LinearFit<3>;
template class ParticleFields<2>;
template class ParticleFields<3>;

}  // namespace mote
