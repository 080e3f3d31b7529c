#pragma once

#include "mote/operators/differential/sph.hpp"
#include "mote/operators/weights/softened_reciprocal.hpp"

namespace mote {

/// MPS as the limit of smoothed particle hydrodynamics (Isshiki 2014, section 4): the sums of SPH
/// with w' = -w/r and w'' = 2 w/r^2 of the weight (54),
///   g_ij = -(m_j/rho_i) w_ij x_ij/r_ij^2                                            (51), (52)
///   l_ij = (m_j/rho_i) w_ij/r_ij^2 [3 - D - (2/rho_i) x_ij . sum_k m_k w_ik x_ik/r_ik^2]
/// the latter being -1 times the summand of (53), which has u_i - u_j.
template <int D>
class MpsAsSph final : public KernelSums<D, SoftenedReciprocal<D>, Matter> {
 public:
  static constexpr std::string_view family = "mps_as_sph";
  static constexpr std::string_view summary =
      "the sums of sph with the weight of MPS, (51) to (55)";
};

}  // namespace mote
