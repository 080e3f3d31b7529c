#include "mote/app/neighbourhood.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mote/output/particle_ids.hpp"

namespace mote {
namespace {

std::span<const double> place(const Cloud& cloud, Index i) {
  const auto dimension = static_cast<std::size_t>(cloud.dimension());
  return cloud.position().subspan(static_cast<std::size_t>(i) * dimension, dimension);
}

/// Square of the distance between two particles, infinite where one is nowhere.
double distance2(const Cloud& cloud, Index i, Index j) {
  double sum = 0;
  for (int c = 0; c < cloud.dimension(); ++c)
    sum += std::pow(place(cloud, i)[c] - place(cloud, j)[c], 2);
  return std::isnan(sum) ? std::numeric_limits<double>::infinity() : sum;
}

std::vector<Index> next_in_number(const Cloud& cloud, const std::vector<Index>& particles) {
  const Index first = std::max(0, particles.front() - 1);
  const Index last = std::min(cloud.count() - 1, particles.back() + 1);
  std::vector<Index> found(static_cast<std::size_t>(last - first + 1));
  std::iota(found.begin(), found.end(), first);
  return found;
}

/// The particles, then the five others nearest to the first of them.
std::vector<Index> nearest(const Cloud& cloud, const std::vector<Index>& particles) {
  std::vector<std::pair<double, Index>> others;
  for (Index i = 0; i < cloud.count(); ++i)
    if (std::ranges::find(particles, i) == particles.end())
      others.emplace_back(distance2(cloud, particles.front(), i), i);
  const std::size_t shown = std::min<std::size_t>(5, others.size());
  std::ranges::partial_sort(others, others.begin() + static_cast<std::ptrdiff_t>(shown));
  std::vector<Index> found = particles;
  for (std::size_t k = 0; k < shown; ++k) found.push_back(others[k].second);
  return found;
}

std::string in_words(std::span<const double> place) {
  if (place.size() == 1) return fmt::format("{:.6g}", place[0]);
  return fmt::format("({:.6g})", fmt::join(place, ", "));
}

}  // namespace

std::string neighbourhood(const Cloud& cloud, const std::vector<Index>& particles) {
  if (particles.empty()) return "";
  std::string text;
  for (const Index i :
       cloud.dimension() == 1 ? next_in_number(cloud, particles) : nearest(cloud, particles))
    text += fmt::format("{}{} at {}", text.empty() ? "" : ", ", id_of(cloud, i),
                        in_words(place(cloud, i)));
  return text;
}

}  // namespace mote
