#include "mote/models/free_stream.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>

#include "mote/particles/failure.hpp"
#include "mote/particles/parallel.hpp"

namespace mote {

template <int D>
FreeStream<D>::FreeStream(const std::vector<std::string>& formulas, const SpaceStart& start,
                          const std::string& key)
    : step_(1e-3 * start.spacing) {
  if (!formulas.empty() && formulas.size() != D)
    throw InputError("model." + key,
                     fmt::format("'{}' needs {} formulas, one a dimension, and has {}", key, D,
                                 formulas.size()));
  formulas_.resize(static_cast<std::size_t>(omp_get_max_threads()));
  for (auto& mine : formulas_)
    for (const std::string& formula : formulas) mine.push_back(start.compile(formula));
}

template <int D>
void FreeStream<D>::add(std::span<const double> position, double time,
                        std::span<double> velocity) const {
  if (!exists()) return;
  const auto count = static_cast<Index>(position.size() / D);
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i) {
    const auto& formulas = formulas_[static_cast<std::size_t>(omp_get_thread_num())];
    Triple place{};
    std::copy_n(position.begin() + std::ptrdiff_t{i} * D, D, place.begin());
    for (std::size_t d = 0; d < D; ++d)
      velocity[static_cast<std::size_t>(i) * D + d] += formulas[d](place, time);
  }
}

template <int D>
void FreeStream<D>::add_gradient(std::span<const double> position, double time,
                                 std::span<double> gradient) const {
  if (!exists()) return;
  const auto count = static_cast<Index>(position.size() / D);
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i) {
    const auto& formulas = formulas_[static_cast<std::size_t>(omp_get_thread_num())];
    const auto first = static_cast<std::size_t>(i) * D;
    for (std::size_t b = 0; b < D; ++b) {
      Triple before{}, after{};
      std::copy_n(position.begin() + static_cast<std::ptrdiff_t>(first), D, before.begin());
      after = before;
      before[b] -= step_;
      after[b] += step_;
      for (std::size_t a = 0; a < D; ++a)
        gradient[(first + a) * D + b] +=
            (formulas[a](after, time) - formulas[a](before, time)) / (after[b] - before[b]);
    }
  }
}

template class FreeStream<2>;
template class FreeStream<3>;

}  // namespace mote
