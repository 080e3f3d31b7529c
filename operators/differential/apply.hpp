#pragma once

#include <span>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"

namespace mote {

/// Calls row(i, neighbours, weights) for every receiver, with room for one weight a neighbour.
/// The room belongs to the thread and is kept, so nothing is allocated after the first call.
template <class Weight, class Row>
void for_each_row(const NeighbourLists& lists, Row row) {
#pragma omp parallel if (parallel_from <= lists.receivers())
  {
    static thread_local std::vector<Weight> room;
#pragma omp for schedule(static)
    for (Index i = 0; i < lists.receivers(); ++i) {
      const auto neighbours = lists[i];
      if (room.size() < neighbours.size()) room.resize(2 * neighbours.size());
      row(i, neighbours, std::span(room).first(neighbours.size()));
    }
  }
}

/// (grad f)_i = sum_j g_ij (f_j - f_i). `values` has one number a point, `result` D a receiver.
template <int D>
void gradient(const DifferentialOperator<D>& op, const NeighbourLists& lists,
              std::span<const double> values, std::span<double> result) {
  for_each_row<Vec<D>>(lists, [&](Index i, auto neighbours, auto weights) {
    op.gradient_weights(i, weights);
    Vec<D> sum = Vec<D>::Zero();
    for (std::size_t k = 0; k < neighbours.size(); ++k)
      sum += weights[k] * (values[neighbours[k]] - values[i]);
    Vec<D>::Map(result.data() + std::ptrdiff_t{i} * D) = sum;
  });
}

/// (div a)_i = sum_j g_ij . (a_j - a_i), (29). `values` has D numbers a point, `result` one a
/// receiver.
template <int D>
void divergence(const DifferentialOperator<D>& op, const NeighbourLists& lists,
                std::span<const double> values, std::span<double> result) {
  const auto vector = [&](Index i) { return Vec<D>::Map(values.data() + std::ptrdiff_t{i} * D); };
  for_each_row<Vec<D>>(lists, [&](Index i, auto neighbours, auto weights) {
    op.gradient_weights(i, weights);
    double sum = 0;
    for (std::size_t k = 0; k < neighbours.size(); ++k)
      sum += weights[k].dot(vector(neighbours[k]) - vector(i));
    result[i] = sum;
  });
}

/// (lap f)_i = sum_j l_ij (f_j - f_i). `values` has one number a point, `result` one a receiver.
template <int D>
void laplacian(const DifferentialOperator<D>& op, const NeighbourLists& lists,
               std::span<const double> values, std::span<double> result) {
  for_each_row<double>(lists, [&](Index i, auto neighbours, auto weights) {
    op.laplacian_weights(i, weights);
    double sum = 0;
    for (std::size_t k = 0; k < neighbours.size(); ++k)
      sum += weights[k] * (values[neighbours[k]] - values[i]);
    result[i] = sum;
  });
}

}  // namespace mote
