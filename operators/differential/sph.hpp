#pragma once

#include "mote/operators/differential/kernel_sums.hpp"

namespace mote {

/// What smoothed particle hydrodynamics smooths: mass.
struct Matter {
  static constexpr const char* quantity = "density";
  static constexpr const char* lacking = "sph needs particles with mass, and these have none";

  template <int D>
  static const std::vector<double>& amount(const Points<D>& points) {
    return points.mass;
  }
  template <int D>
  static const std::vector<double>& density(const Points<D>& points) {
    return points.density;
  }
};

/// Smoothed particle hydrodynamics as printed (Isshiki 2014, (27) to (30)).
template <int D, class Kernel>
class Sph final : public KernelSums<D, Kernel, Matter> {
  static_assert(SmoothingKernel<Kernel>);

 public:
  static constexpr std::string_view family = "sph";
  static constexpr std::string_view summary =
      "smoothed particle hydrodynamics as printed, (27) to (30)";
};

}  // namespace mote
