#pragma once

#include <span>
#include <string_view>

namespace mote {

/// How sums over all pairs of points are formed.
enum class SumMethod {
  direct,        ///< pair by pair, in O(N M)
  power_series,  ///< one expansion for all, for sources and targets apart (Tabanjeh 2014, section
                 ///< 7)
  multipole      ///< an adaptive fast multipole method, in O(N + M)
};

/// What `SumMethod` is called, in its order.
inline constexpr std::string_view sum_methods[] = {"direct", "power_series", "multipole"};

struct SumSettings {
  SumMethod method = SumMethod::multipole;
  double tolerance = 1e-8;  ///< of the multipole method: error over the largest value of the sum
};

/// Sources of a field in D dimensions. Positions are D numbers a source, one after the other.
template <int D>
struct Sources {
  std::span<const double> position;
  std::span<const double> strength;  ///< mass or circulation; 3 numbers a vortex in 3D
  double core_size = 0;              ///< of blobs, in the unit of positions; points have none
};

}  // namespace mote
