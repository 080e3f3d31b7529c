#include "mote/neighbours/cell_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mote/particles/parallel.hpp"

namespace mote {
namespace {

/// Cells are wider than the reach by this, and none is farther than 2^28 of them from
/// the origin. So two points
/// within reach stand in the same cell or in adjacent ones although x / width is rounded.
constexpr double widening = 1 + 1e-5;
constexpr double farthest_side = 0x1p26;

/// Empty cells at each end of an axis: as many as a search looks beyond a cell, and one to spare.
template <int D>
constexpr Index rim(int d) {
  return d == 0 ? CellLayout<D>::fineness + 2 : 1;
}

template <int D>
struct Box {
  std::array<double, D> lower, upper;

  void take(const double* at) {
    for (int d = 0; d < D; ++d) {
      lower[d] = std::min(lower[d], at[d]);
      upper[d] = std::max(upper[d], at[d]);
    }
  }
};

/// The box around points: an extreme is the same in any order.
template <int D>
Box<D> box_around(std::span<const double> position) {
  constexpr Index pieces = 16;
  const auto count = static_cast<std::int64_t>(position.size() / D);
  Box<D> first;
  std::copy_n(position.begin(), D, first.lower.begin());
  std::copy_n(position.begin(), D, first.upper.begin());
  std::array<Box<D>, pieces> boxes;
  boxes.fill(first);
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index piece = 0; piece < pieces; ++piece) {
    Box<D> box = first;
    for (auto i = count * piece / pieces; i < count * (piece + 1) / pieces; ++i)
      box.take(position.data() + i * D);
    boxes[piece] = box;
  }
  for (const auto& box : boxes) {
    first.take(box.lower.data());
    first.take(box.upper.data());
  }
  return first;
}

}  // namespace

template <int D>
CellLayout<D>::CellLayout(std::span<const double> position, double reach) {
  const Box<D> box = box_around<D>(position);
  double farthest = 0;
  for (int d = 0; d < D; ++d)
    farthest = std::max({farthest, std::abs(box.lower[d]), std::abs(box.upper[d])});
  double side = std::max(reach * widening, farthest / farthest_side);
  if (side < std::numeric_limits<double>::min()) side = 1;
  corner = box.lower;
  per_rough_unit = 1 / side;
  std::array<double, D> wanted;
  for (int d = 0; d < D; ++d) {
    width[d] = d == 0 ? side / fineness : side;
    inverse[d] = 1 / width[d];
    lowest[d] = on_axis(box.lower[d], d) - rim<D>(d);
    rough_extent = std::max(rough_extent, in_rough_unit(box.upper[d] - box.lower[d]));
    wanted[d] = on_axis(box.upper[d], d) - lowest[d] + rim<D>(d) + 1;
  }
  fold(wanted, position.size() / D);
}

/// Halves axes until the cells are not many more than the points, each time the one that is longest
/// in comparison to what a search sees of it at once: no axis becomes shorter than that. Extents
/// are odd and even, so that a diagonal does not fold onto itself.
template <int D>
void CellLayout<D>::fold(std::array<double, D> wanted, std::size_t points) {
  const double limit = 4 * static_cast<double>(points) + 4096;
  const auto product = [&] {
    double product = 1;
    for (const double cells : wanted) product *= cells;
    return product;
  };
  const auto views = [&](int d) { return wanted[d] / (2 * rim<D>(d) + (d == 0 ? 0 : 1)); };
  while (product() > limit) {
    int longest = 0;
    for (int d = 1; d < D; ++d)
      if (views(d) > views(longest)) longest = d;
    is_folded = true;
    wanted[longest] = std::floor(wanted[longest] / 2) + (longest == 0 ? 0 : 1);
  }
  cells = 1;
  for (int d = 0; d < D; ++d) cells *= extent[d] = static_cast<Index>(wanted[d]);
}

template struct CellLayout<1>;
template struct CellLayout<2>;
template struct CellLayout<3>;

}  // namespace mote
