#pragma once

#include <array>
#include <span>
#include <vector>

#include "mote/xivas/projection.hpp"
#include "mote/xivas/streamlines.hpp"

namespace mote {

/// Particles with their velocities and accelerations, D numbers each.
struct MovingParticles {
  std::vector<double> position, velocity, acceleration;
};

/// Two opposite corners of a box with sides along the axes.
template <int D>
struct MeshBox {
  Vec<D> lower, upper;
};

/// A linear vector field, the one that fits given vectors best.
template <int D>
class LinearFit {
 public:
  LinearFit(std::span<const double> places, std::span<const double> vectors);
  Vec<D> at(const Vec<D>& place) const;

 private:
  Vec<D> centre_;
  double scale_ = 1;
  Eigen::Matrix<double, D, D + 1> coefficients_;
};

/// The velocities and accelerations of particles as fields about them, on a mesh of their own, and
/// where the particles come to in these fields: Nadukandi 2014, section 3.1, for one step.
///
/// The mesh is a lattice of simplices over the box of the particles and as far beyond as they may
/// go. Vectors are projected in two parts: the linear field that fits all of them best, which the
/// mesh carries exactly everywhere, and what that leaves, by least squares about every point of
/// the mesh. What the projection loses of a particle's own velocity and acceleration the particle
/// keeps on its way as constants, so that nothing is smeared out, and the fields say only how both
/// change from place to place. Beyond the mesh a particle goes on as it left.
///
/// A mesh whose points are the particles would need no projection. But its cells are as thin as
/// particles on a line, at a surface above all, and gradients in thin cells mean nothing.
template <int D>
class ParticleFields {
 public:
  /// Of particles in a space of these periods, 0 where it is not periodic, for a step that is so
  /// long. Throws NumericalFailure for places or vectors that are not finite.
  ParticleFields(MovingParticles particles, const std::array<double, 3>& periods, double step);
  ParticleFields(const ParticleFields&) = delete;
  ParticleFields& operator=(const ParticleFields&) = delete;

  /// What each of the particles goes and gains in the step, over its length: (23) and (24).
  std::vector<OwnMotion<D>> mean_motions() const;

  const SimplexMesh<D>& mesh() const { return mesh_; }

 private:
  void add_images(int axis, double period);
  std::vector<Index> cells_of_particles() const;
  std::vector<double> project(const Projection<D>& projection, std::vector<double> vectors) const;
  OwnMotion<D> mean_motion(Index i) const;

  MovingParticles particles_;  ///< and behind them their images through periodic sides
  Index count_;                ///< without images
  double step_;
  MeshBox<D> box_;
  SimplexMesh<D> mesh_;
  std::vector<Index> cells_;                     ///< of particles and images
  std::vector<double> velocity_, acceleration_;  ///< at the points of the mesh
  Streamlines<D> streamlines_;
};

extern template class LinearFit<2>;
extern template class LinearFit<3>;
extern template class ParticleFields<2>;
extern template class ParticleFields<3>;

}  // namespace mote
