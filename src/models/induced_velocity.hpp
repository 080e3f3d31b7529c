#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "mote/models/chosen_sum.hpp"
#include "mote/models/space.hpp"
#include "mote/sums/biot_savart.hpp"

namespace mote {

/// The velocity that vortices induce, be it in an unbounded fluid or in a periodic box.
template <int D>
class InducedVelocity {
 public:
  virtual ~InducedVelocity() = default;

  /// At the vortices themselves; the gradient in space only, if it is asked for.
  virtual void at_sources(const Sources<D>& sources, const VelocityField& result) = 0;
  /// The vorticity of blobs at the same places: one number each, or three in space.
  virtual void vorticity_at_sources(const Sources<D>& sources, std::span<double> vorticity) = 0;

  /// Whose gradients move the vortices, where it is known: in the unbounded plane
  /// -1/(4 pi) sum over pairs i != j of Gamma_i Gamma_j ln r_ij, for blobs with their cores; in
  /// space 1/(8 pi) sum of alpha_i . alpha_j/r_ij, the kinetic energy of a fluid of density 1.
  virtual std::optional<double> hamiltonian(const Sources<D>& sources) = 0;
};

/// The sum that fits the domain: in a box that is periodic along all axes with all images, else in
/// an unbounded fluid. Throws InputError for a domain that is periodic along some axes only, or
/// periodic in space.
template <int D>
std::unique_ptr<InducedVelocity<D>> induced_velocity(const SumChoice& options,
                                                     const SpaceStart& start);

extern template std::unique_ptr<InducedVelocity<2>> induced_velocity<2>(const SumChoice&,
                                                                        const SpaceStart&);

extern template std::unique_ptr<InducedVelocity<3>> induced_velocity<3>(const SumChoice&,
                                                                        const SpaceStart&);

}  // namespace mote
