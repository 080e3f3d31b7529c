#include "mote/models/lagrangian_radii.hpp"

#include <algorithm>
#include <numeric>

namespace mote {

std::vector<double> lagrangian_radii(std::span<const double> distance, std::span<const double> mass,
                                     const std::vector<double>& parts) {
  std::vector<std::size_t> order(distance.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return distance[i]; });
  std::vector<double> within;  // of the mass
  double sum = 0;
  for (const std::size_t i : order) within.push_back(sum += mass[i]);
  std::vector<double> radii;
  for (const double part : parts) {
    const auto first = std::ranges::lower_bound(within, part * sum) - within.begin();
    const auto last = static_cast<std::ptrdiff_t>(order.size()) - 1;
    radii.push_back(distance[order[static_cast<std::size_t>(std::min(first, last))]]);
  }
  return radii;
}

}  // namespace mote
