#include "mote/models/free_stream.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>

#include "mote/particles/failure.hpp"
#include "mote/particles/parallel.hpp"

namespace mote {

template <int D>
FreeStream<D>::FreeStream(const std::vector<std::string>& formulas, const SpaceStart& start) {
  if (!formulas.empty() && formulas.size() != D)
    throw InputError("model.free_stream",
                     fmt::format("'free_stream' needs {} formulas, one a dimension, and has {}", D,
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

template class FreeStream<2>;

}  // namespace mote
