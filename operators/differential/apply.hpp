#pragma once

#include <Eigen/Geometry>
#include <exception>
#include <span>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"

namespace mote {

/// What was thrown first, by the number of the receiver, in a loop that threads share: an exception
/// must not leave such a loop.
class FirstFailure {
 public:
  template <class Work>
  void guard(Index i, Work work) {
    try {
      work();
    } catch (...) {
#pragma omp critical(mote_first_failure)
      if (!failure_ || i < receiver_) {
        failure_ = std::current_exception();
        receiver_ = i;
      }
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
  Index receiver_ = 0;
};

/// Calls row(i, neighbours, weights) for every receiver, with room for one weight a neighbour.
/// The room belongs to the thread and is kept, so nothing is allocated after the first call.
template <class Weight, class Row>
void for_each_row(const NeighbourLists& lists, Row row) {
  FirstFailure failure;
#pragma omp parallel if (parallel_from <= lists.receivers())
  {
    static thread_local std::vector<Weight> room;
#pragma omp for schedule(static)
    for (Index i = 0; i < lists.receivers(); ++i) {
      const auto neighbours = lists[i];
      failure.guard(i, [&] {
        if (room.size() < neighbours.size()) room.resize(2 * neighbours.size());
        row(i, neighbours, std::span(room).first(neighbours.size()));
      });
    }
  }
  failure.rethrow();
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

/// (curl a)_i = sum_j g_ij x (a_j - a_i). `values` has D numbers a point; `result` has one number a
/// receiver in 2D, where the curl points out of the plane, and three in 3D.
template <int D>
void curl(const DifferentialOperator<D>& op, const NeighbourLists& lists,
          std::span<const double> values, std::span<double> result) {
  static_assert(D > 1);
  const auto vector = [&](Index i) { return Vec<D>::Map(values.data() + std::ptrdiff_t{i} * D); };
  for_each_row<Vec<D>>(lists, [&](Index i, auto neighbours, auto weights) {
    op.gradient_weights(i, weights);
    Vec<3> sum = Vec<3>::Zero();
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      Vec<3> g = Vec<3>::Zero(), a = Vec<3>::Zero();
      g.template head<D>() = weights[k];
      a.template head<D>() = vector(neighbours[k]) - vector(i);
      sum += g.cross(a);
    }
    if constexpr (D == 2) result[i] = sum[2];
    if constexpr (D == 3) Vec<3>::Map(result.data() + std::ptrdiff_t{i} * 3) = sum;
  });
}

/// (hess f)_i = sum_j H_ij (f_j - f_i). `values` has one number a point, `result` the D x D numbers
/// of a symmetric matrix a receiver.
template <int D>
void hessian(const DifferentialOperator<D>& op, const NeighbourLists& lists,
             std::span<const double> values, std::span<double> result) {
  for_each_row<Mat<D>>(lists, [&](Index i, auto neighbours, auto weights) {
    op.hessian_weights(i, weights);
    Mat<D> sum = Mat<D>::Zero();
    for (std::size_t k = 0; k < neighbours.size(); ++k)
      sum += weights[k] * (values[neighbours[k]] - values[i]);
    Mat<D>::Map(result.data() + std::ptrdiff_t{i} * D * D) = sum;
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
