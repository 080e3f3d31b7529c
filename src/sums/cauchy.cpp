#include "mote/sums/cauchy.hpp"

#include <fmt/format.h>

#include "mote/particles/failure.hpp"
#include "mote/sums/power_series.hpp"

namespace mote {

/// Stands in until the methods of the Cauchy sum are there: pair by pair.
class Cauchy::Sum {
 public:
  explicit Sum(const SumSettings& settings) : settings(settings) {}
  SumSettings settings;
};

Cauchy::Cauchy(const SumSettings& settings) : sum_(std::make_unique<Sum>(settings)) {}
Cauchy::~Cauchy() = default;

void Cauchy::at_sources(std::span<const Complex> points, std::span<const Complex> strengths,
                        std::span<Complex> result) {
  if (sum_->settings.method == SumMethod::power_series)
    throw InputError(
        "power_series serves targets apart from the sources, not the sources themselves");
  for (std::size_t i = 0; i < points.size(); ++i) {
    result[i] = 0;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j != i && points[i] == points[j])
        throw InputError(fmt::format("the points {} and {} coincide", j, i));
      if (j != i) result[i] += strengths[j] / (points[i] - points[j]);
    }
  }
}

void Cauchy::at(std::span<const Complex> targets, std::span<const Complex> sources,
                std::span<const Complex> strengths, std::span<Complex> result) {
  if (sum_->settings.method == SumMethod::power_series)
    return power_series(targets, sources, strengths, sum_->settings.tolerance, result);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    result[i] = 0;
    for (std::size_t j = 0; j < sources.size(); ++j) {
      if (targets[i] == sources[j])
        throw InputError(fmt::format("target {} stands on source {}", i, j));
      result[i] += strengths[j] / (targets[i] - sources[j]);
    }
  }
}

}  // namespace mote
