#pragma once

#include <Eigen/Core>
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

/// What the coordinates are called, in files and messages.
inline constexpr const char* axis_names[] = {"x", "y", "z"};

}  // namespace mote
