#pragma once

#include "mote/operators/kernels/cubic_spline.hpp"
#include "mote/operators/kernels/gauss.hpp"
#include "mote/operators/kernels/lucy.hpp"
#include "mote/operators/kernels/quintic_spline.hpp"
#include "mote/operators/kernels/truncated_gauss.hpp"
#include "mote/operators/kernels/wendland_c2.hpp"
#include "mote/operators/kernels/wendland_c4.hpp"
#include "mote/operators/kernels/wendland_c6.hpp"

namespace mote {

/// A list of kernels, each a template over the dimension.
template <template <int> class... K>
struct KernelList {};

/// Calls `visit.template operator()<K>()` for every kernel of the list, in order.
template <template <int> class... K, class Visit>
constexpr void for_each_kernel(KernelList<K...>, Visit&& visit) {
  (visit.template operator()<K>(), ...);
}

/// The smoothing kernels of mote. A new one is its own file and a word here.
using Kernels = KernelList<Gauss, TruncatedGauss, TruncatedGaussCosine, Lucy, CubicSpline,
                           QuinticSpline, WendlandC2, WendlandC4, WendlandC6>;

}  // namespace mote
