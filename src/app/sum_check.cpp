#include "mote/app/sum_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "mote/app/reference_sum.hpp"
#include "mote/particles/random.hpp"

namespace mote {
namespace {

std::vector<std::size_t> sampled_targets(std::size_t count) {
  constexpr std::uint64_t seed = 1;
  std::vector<std::size_t> targets(std::min(count, verified_targets));
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const double stretch = static_cast<double>(count) / static_cast<double>(targets.size());
    const double place = (static_cast<double>(k) + uniform_random(seed, k)) * stretch;
    targets[k] =
        count <= verified_targets ? k : std::min(static_cast<std::size_t>(place), count - 1);
  }
  return targets;
}

long double length(std::span<const long double> components) {
  long double square = 0;
  for (const long double component : components) square += component * component;
  return std::sqrt(square);
}

std::vector<long double> at_target(const SummedField& field, std::size_t target) {
  const std::size_t width = field.columns.size();
  const auto first = field.values.begin() + static_cast<std::ptrdiff_t>(target * width);
  return {first, first + static_cast<std::ptrdiff_t>(width)};
}

long double largest_value(const SummedField& field) {
  long double largest = 0;
  for (std::size_t i = 0; i < field.values.size() / field.columns.size(); ++i)
    largest = std::max(largest, length(at_target(field, i)));
  return largest;
}

/// The error of each field at a target, whose right numbers stand one after the other.
std::vector<long double> errors_at(const std::vector<SummedField>& fields, std::size_t target,
                                   std::vector<long double> right) {
  std::vector<long double> errors;
  std::span<long double> rest = right;
  for (const SummedField& field : fields) {
    const auto found = at_target(field, target);
    const auto difference = rest.first(found.size());
    for (std::size_t c = 0; c < found.size(); ++c) difference[c] -= found[c];
    errors.push_back(length(difference));
    rest = rest.subspan(found.size());
  }
  return errors;
}

/// A part of nothing is nothing if it is 0 itself.
double relative(long double error, long double size) {
  if (error == 0) return 0;
  return size > 0 ? static_cast<double>(error / size) : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<double> sampled_errors(const SumTask& task, const SumPoints& points,
                                   const std::vector<SummedField>& fields) {
  const auto right = reference_sum(task, points);
  const auto targets = sampled_targets(points.target_count());
  std::vector<std::vector<long double>> errors(targets.size());
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < targets.size(); ++k)
    errors[k] = errors_at(fields, targets[k], right(targets[k]));
  std::vector<double> largest;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    long double error = 0;
    for (const auto& of_target : errors) error = std::max(error, of_target[f]);
    largest.push_back(relative(error, largest_value(fields[f])));
  }
  return largest;
}

}  // namespace mote
