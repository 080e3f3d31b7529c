#include "mote/xivas/streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mote/particles/failure.hpp"
#include "mote/xivas/linear_path.hpp"
#include "mote/xivas/matrix_exponentials.hpp"

namespace mote {
namespace {

/// No less than the fastest growth of distances, the largest eigenvalue of the symmetric part: by
/// the theorem of Gershgorin.
template <int D>
double fastest_growth(const Mat<D>& gradient) {
  const Mat<D> symmetric = (gradient + gradient.transpose()) / 2;
  double fastest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < D; ++i)
    fastest = std::max(
        fastest, symmetric(i, i) + symmetric.row(i).cwiseAbs().sum() - std::abs(symmetric(i, i)));
  return fastest;
}

/// No less than the length of the way in a linear field: |v| (e^(g t) - 1) / g.
template <int D>
double reach(const Mat<D>& gradient, const Vec<D>& velocity, double time) {
  const double growth = fastest_growth<D>(gradient);
  return velocity.norm() * (growth == 0 ? time : std::expm1(growth * time) / growth);
}

/// Not numbers have no finite square either.
template <int D>
void refuse_what_is_too_large(const Mat<D>& gradient, const Vec<D>& velocity) {
  if (std::isfinite(gradient.squaredNorm()) && std::isfinite(velocity.squaredNorm())) return;
  throw NumericalFailure(
      "the square of the velocity on a streamline or of its gradient is not finite", {},
      "values at points of the mesh are not finite, or much too large");
}

template <int D>
void refuse_endless_walk(Index crossings, const SimplexMesh<D>& mesh) {
  if (crossings <= mesh.cell_count()) return;
  throw NumericalFailure("a walk around a corner of the mesh does not end", {},
                         "cells of the mesh are as thin as rounding");
}

}  // namespace

template <int D>
Vec<D> Streamlines<D>::acceleration(const Passage<D>& at) const {
  if (!acceleration_) return at.own.acceleration;
  return acceleration_->value(at.cell, at.position) + at.own.acceleration;
}

template <int D>
Passage<D> Streamlines<D>::follow(const Vec<D>& from, Index cell, double time,
                                  const OwnMotion<D>& own) const {
  Passage<D> at{.position = from, .cell = cell, .own = own};
  continue_to(time, at);
  return at;
}

template <int D>
void Streamlines<D>::continue_to(double time, Passage<D>& at) const {
  Index standing = 0;  // crossings since time went on: at an edge or a corner
  while (!at.left && at.time.value() < time) {
    const Mat<D> gradient = velocity_.gradient(at.cell);
    const Vec<D> velocity = this->velocity(at);
    refuse_what_is_too_large<D>(gradient, velocity);
    const double remaining = at.time.lacks(time);
    if (stays(gradient, velocity, at, remaining)) {
      finish_within(gradient, velocity, remaining, at);
      at.time = CompensatedSum(time);
    } else {
      const double before = at.time.value();
      go_on(gradient, velocity, remaining, at);
      standing = at.time.value() > before ? 0 : standing + 1;
      refuse_endless_walk(standing, velocity_.mesh());
    }
  }
}

template <int D>
bool Streamlines<D>::stays(const Mat<D>& gradient, const Vec<D>& velocity, const Passage<D>& at,
                           double time) const {
  const double far = reach<D>(gradient, velocity, time);
  if (far == 0) return true;
  return std::ranges::all_of(velocity_.mesh().cell(at.cell).faces, [&](const MeshFace<D>& face) {
    return face.distance(at.position) + far <= 0;
  });
}

/// (23), (24), of a point that meets no face.
template <int D>
void Streamlines<D>::finish_within(const Mat<D>& gradient, const Vec<D>& velocity, double time,
                                   Passage<D>& at) const {
  const auto of = matrix_exponentials<double, D>(gradient, time);
  add_gain(time, of.r * velocity, at);
  at.position += of.q * velocity;
}

/// To the first face, or as far as one series goes.
template <int D>
void Streamlines<D>::go_on(const Mat<D>& gradient, const Vec<D>& velocity, double time,
                           Passage<D>& at) const {
  const LinearPath<D> path(gradient, velocity, time, velocity_.mesh().extent());
  const MeshFace<D>* exit = nullptr;
  double part = 1;
  for (const MeshFace<D>& face : velocity_.mesh().cell(at.cell).faces) {
    const auto distance = path.along(face.normal, face.distance(at.position));
    const double crossing =
        first_crossing(std::span(distance).first(static_cast<std::size_t>(path.terms()) + 1),
                       velocity_.mesh().tolerance(), part);
    if (crossing >= part) continue;
    part = crossing;
    exit = &face;
  }
  add_gain(part * path.duration(), path.integral(part), at);
  at.position += path.displacement(part);
  at.time.add(part * path.duration());
  if (exit == nullptr) return;
  at.left = exit->neighbour == no_cell;
  if (at.left) at.outward = exit->normal;
  if (at.left) return;
  at.cell = exit->neighbour;
  ++at.crossings;
}

template <int D>
void Streamlines<D>::add_gain(double time, const Vec<D>& integral, Passage<D>& at) const {
  at.gain += time * acceleration(at);
  if (acceleration_) at.gain += acceleration_->gradient(at.cell) * integral;
}

template <int D>
double Streamlines<D>::courant_number(double time) const {
  const SimplexMesh<D>& mesh = velocity_.mesh();
  double largest = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (const Index vertex : mesh.cell(c).vertices)
      for (const MeshFace<D>& face : mesh.cell(c).faces)
        largest = std::max(largest, std::abs(face.gradient().dot(velocity_.at_point(vertex))));
  return largest * time;
}

template class Streamlines<2>;
template class Streamlines<3>;

}  // namespace mote
