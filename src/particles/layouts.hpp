#pragma once

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "mote/options/type_list.hpp"
#include "mote/particles/random.hpp"
#include "mote/particles/vector.hpp"

namespace mote {

/// Cells of a line: particle i sits in the middle of a cell of length[i] (Isshiki 2014, (57)).
struct Cells {
  std::vector<double> centre;
  std::vector<double> length;
};

/// The five meshes of Isshiki (2014), Table 2. A mesh gives the relative length of cell i of
/// `count`, i also below 0 and beyond count - 1 for cells outside the region; the factor alpha that
/// makes them fill the region is found in `cells_of_line`.
struct Regular {
  static constexpr std::string_view name = "regular";
  static constexpr std::string_view summary = "cells of equal length";
  static double relative_length(Index, Index, std::uint64_t) { return 1; }
};

struct Algebraic {
  static constexpr std::string_view name = "algebraic";
  static constexpr std::string_view summary = "lengths grow by L/100 from cell to cell";
  static double relative_length(Index i, Index count, std::uint64_t) {
    return 1.0 / count + i / 100.0;
  }
};

struct Geometric {
  static constexpr std::string_view name = "geometric";
  static constexpr std::string_view summary = "lengths grow by 5 % from cell to cell";
  static double relative_length(Index i, Index, std::uint64_t) { return std::pow(1.05, i - 1); }
};

struct Random {
  static constexpr std::string_view name = "random";
  static constexpr std::string_view summary = "lengths vary at random by up to 6.25 %";
  static double relative_length(Index i, Index, std::uint64_t seed) {
    constexpr std::uint64_t stream_below = 1000;  // of the cells below the region, nearest first
    return 1 +
           0.0625 * (i < 0 ? uniform_random(seed + stream_below, static_cast<std::uint64_t>(-1 - i))
                           : uniform_random(seed, static_cast<std::uint64_t>(i)));
  }
};

struct Sinusoidal {
  static constexpr std::string_view name = "sinusoidal";
  static constexpr std::string_view summary = "lengths vary by half as two periods of a sine";
  static double relative_length(Index i, Index count, std::uint64_t) {
    return 1 + 0.5 * std::sin(4 * std::numbers::pi * i / count);
  }
};

using Layouts = TypeList<Regular, Algebraic, Geometric, Random, Sinusoidal>;

/// The cells of `Layout` that fill [lower, upper].
template <class Layout>
Cells cells_of_line(double lower, double upper, Index count, std::uint64_t seed) {
  std::vector<double> edge(static_cast<std::size_t>(count) + 1, 0.0);
  Cells cells;
  for (Index i = 0; i < count; ++i) {
    cells.length.push_back(Layout::relative_length(i, count, seed));
    edge[i + 1] = edge[i] + cells.length[i];
  }
  const double size = upper - lower;
  for (Index i = 0; i < count; ++i) {
    cells.centre.push_back(lower + size * (0.5 * (edge[i] + edge[i + 1]) / edge[count]));
    cells.length[i] *= size / edge[count];
  }
  return cells;
}

}  // namespace mote
