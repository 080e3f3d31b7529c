#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "mote/neighbours/neighbours.hpp"
#include "mote/options/description.hpp"

namespace mote {

/// An operator in any dimension: its options, and which neighbours it needs.
class AnyOperator {
 public:
  virtual ~AnyOperator() = default;

  /// Says which options the operator takes, and takes them.
  virtual void describe(Description& description) = 0;

  /// Which neighbours the lists must hold.
  virtual NeighbourRule neighbour_rule() const = 0;

  /// Whether it needs points with circulation.
  virtual bool needs_circulation() const { return false; }

  /// What a reader of the report should know about the points last prepared.
  virtual std::vector<std::string> remarks() const { return {}; }
};

/// The one idea of mote: a differential operator is a rule that gives every neighbour a weight,
///   (grad f)_i = sum_j g_ij (f_j - f_i),   (lap f)_i = sum_j l_ij (f_j - f_i),
/// and, for the matrix of all second derivatives, (hess f)_i = sum_j H_ij (f_j - f_i).
/// SPH, MPS, least squares and finite differences differ in g, l and H alone.
///
/// Weights come a row at a time, for all neighbours of one receiver: one virtual call a particle,
/// inside which everything is static. That costs the same as a plain loop over gathered arrays
/// and serves families that find a whole row at once.
template <int D>
class DifferentialOperator : public AnyOperator {
 public:
  /// Forms the sums per particle that the weights need. The points and lists must outlive the
  /// calls below. Throws NumericalFailure where a receiver has no usable neighbourhood.
  virtual void prepare(const Points<D>& points, const NeighbourLists& lists) = 0;

  /// Whether l_ij = l_ji between receivers of equal mass, density and length.
  virtual bool has_symmetric_laplacian() const { return false; }

  /// g_ij of receiver i, one vector for each of its neighbours in list order. [1/length]
  virtual void gradient_weights(Index i, std::span<Vec<D>> weights) const = 0;

  /// l_ij of receiver i, one number for each of its neighbours in list order. [1/length^2]
  virtual void laplacian_weights(Index i, std::span<double> weights) const = 0;

  /// Both at once, which is cheaper where they share most of the work.
  virtual void both_weights(Index i, std::span<Vec<D>> gradient,
                            std::span<double> laplacian) const {
    gradient_weights(i, gradient);
    laplacian_weights(i, laplacian);
  }

  /// H_ij of receiver i, one symmetric matrix for each of its neighbours in list order; the trace
  /// of H_ij is l_ij. [1/length^2]
  virtual void hessian_weights(Index i, std::span<Mat<D>> weights) const {
    if constexpr (D == 1) return laplacian_weights(i, {weights.data()->data(), weights.size()});
    throw std::logic_error("this operator has no Hessian");
  }

  /// Whether `hessian_weights` can be called: always on a line, where the Hessian is the Laplacian.
  virtual bool has_hessian() const { return D == 1; }
};

/// The two options of every operator whose weights depend on a smoothing length.
inline void describe_lengths(Description& description, double& smoothing_length,
                             PairLength& length) {
  static constexpr Word<PairLength> rules[] = {
      {PairLength::mean, "mean", "the mean of the two points' lengths"},
      {PairLength::scatter, "scatter", "the neighbour's length"},
      {PairLength::gather, "gather", "the receiver's length"}};
  description.number({"smoothing_length", "smoothing length in local spacings"}, smoothing_length,
                     positive);
  describe_words(description, {"length", "whose smoothing length a pair uses"}, length, rules);
}

}  // namespace mote
