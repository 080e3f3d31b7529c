#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace mote {

/// A particle's number; also counts particles and neighbours.
using Index = std::int32_t;

/// A point or vector in D dimensions.
template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

/// A matrix in D dimensions.
template <int D>
using Mat = Eigen::Matrix<double, D, D>;

/// Three numbers; in fewer dimensions the last ones are 0.
using Triple = std::array<double, 3>;

/// What the coordinates are called, in files and messages.
inline constexpr const char* axis_names[] = {"x", "y", "z"};

}  // namespace mote
