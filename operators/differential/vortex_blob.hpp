#pragma once

#include "mote/operators/differential/kernel_sums.hpp"

namespace mote {

/// What the vortex blob method smooths: circulation.
struct Circulation {
  static constexpr const char* quantity = "vorticity";
  static constexpr const char* lacking =
      "vortex_blob needs points with circulation, and these have none";

  template <int D>
  static const std::vector<double>& amount(const Points<D>& points) {
    return points.circulation;
  }
  template <int D>
  static const std::vector<double>& density(const Points<D>& points) {
    return points.vorticity;
  }
};

/// The vortex blob method (Isshiki 2014, (41) to (44)): the operators of smoothed particle
/// hydrodynamics with vorticity in place of density and circulation in place of mass.
template <int D, class Kernel>
class VortexBlob final : public KernelSums<D, Kernel, Circulation> {
  static_assert(SmoothingKernel<Kernel>);

 public:
  static constexpr std::string_view family = "vortex_blob";
  static constexpr std::string_view summary =
      "the sums of sph with circulation in place of mass, (41) to (44)";

  bool needs_circulation() const override { return true; }
};

}  // namespace mote
