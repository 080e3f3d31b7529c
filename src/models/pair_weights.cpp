#include "mote/models/pair_weights.hpp"

#include <algorithm>

#include "mote/operators/differential/apply.hpp"

namespace mote {

template <int D>
void PairWeights<D>::find(const DifferentialOperator<D>& op, const NeighbourLists& lists,
                          Index rows, std::span<std::uint8_t> leave_out) {
  first_.resize(static_cast<std::size_t>(rows) + 1);
  first_[0] = 0;
  for (Index i = 0; i < rows; ++i)
    first_[static_cast<std::size_t>(i) + 1] = first(i) + lists[i].size();
  gradient_.resize(pairs());
  laplacian_.resize(pairs());
  FirstFailure failure;
  std::int64_t used = 0;
#pragma omp parallel for schedule(static) reduction(+ : used) if (parallel_from <= rows)
  for (Index i = 0; i < rows; ++i) {
    const std::size_t count = lists[i].size();
    const auto gradients = std::span(gradient_).subspan(first(i), count);
    const auto laplacians = std::span(laplacian_).subspan(first(i), count);
    std::uint8_t& left_out = leave_out[static_cast<std::size_t>(i)];
    if (left_out == 0) {
      failure.guard(i, [&] { op.both_weights(i, gradients, laplacians); });
      const auto finite = [](const Vec<D>& weight) { return weight.allFinite(); };
      left_out = !std::ranges::all_of(gradients, finite);
    }
    if (left_out != 0) {
      std::ranges::fill(gradients, Vec<D>::Zero());
      std::ranges::fill(laplacians, 0.0);
    }
    used += std::ranges::count_if(laplacians, [](double weight) { return weight != 0; });
  }
  failure.rethrow();
  within_support_ = used;
}

template class PairWeights<2>;
template class PairWeights<3>;

}  // namespace mote
