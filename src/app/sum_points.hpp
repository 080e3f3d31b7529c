#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mote {

/// What is summed over all pairs of points.
enum class SumKernel { cauchy, gravity, biot_savart };

/// What `SumKernel` is called, in its order.
inline constexpr const char* sum_kernels[] = {"cauchy", "gravity", "biot_savart"};

/// Sources, and targets unless they are the sources; numbers point by point.
struct SumPoints {
  std::string file;  ///< of the sources
  int dimension = 2;
  std::vector<double> position, strength;
  bool at_sources = true;
  std::vector<double> targets;

  const std::vector<double>& places() const { return at_sources ? position : targets; }
  std::size_t source_count() const { return position.size() / dimension; }
  std::size_t target_count() const { return places().size() / dimension; }
};

/// Reads sources from the columns x, y and, in 3D, z and their strengths from
///   gravity      mass,
///   biot_savart  circulation, in 3D circulation_x, circulation_y and circulation_z,
///   cauchy       strength_re and strength_im, or strength for real ones;
/// gravity and biot_savart take strength, strength_x, ... where their own name is not there.
/// Targets have the same coordinates. Throws InputError.
SumPoints read_sum_points(SumKernel kernel, const std::filesystem::path& sources,
                          const std::optional<std::string>& targets);

}  // namespace mote
