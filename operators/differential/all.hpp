#pragma once

#include "mote/operators/differential/corrected_mps.hpp"
#include "mote/operators/differential/corrected_sph.hpp"
#include "mote/operators/differential/finite_difference.hpp"
#include "mote/operators/differential/least_squares.hpp"
#include "mote/operators/differential/morris.hpp"
#include "mote/operators/differential/mps.hpp"
#include "mote/operators/differential/mps_as_sph.hpp"
#include "mote/operators/differential/sph.hpp"
#include "mote/operators/differential/vortex_blob.hpp"

namespace mote {

/// A list of operator families built on a smoothing kernel.
template <template <int, class> class... Family>
struct KernelFamilyList {};

template <template <int, class> class... Family, class Visit>
constexpr void for_each_kernel_family(KernelFamilyList<Family...>, Visit&& visit) {
  (visit.template operator()<Family>(), ...);
}

/// A list of operator families without one.
template <template <int> class... Family>
struct FamilyList {};

template <template <int> class... Family, class Visit>
constexpr void for_each_family(FamilyList<Family...>, Visit&& visit) {
  (visit.template operator()<Family>(), ...);
}

/// The operator families of mote. A new one is its own file and a word in one of these lists.
using KernelFamilies = KernelFamilyList<Sph, Morris, CorrectedSph, VortexBlob>;
using PlainFamilies =
    FamilyList<Mps, CorrectedMps, MpsAsSph, Quadratic, Cubic, Quartic, FiniteDifference>;

}  // namespace mote
