#pragma once

#include <Eigen/Core>
#include <span>

namespace mote {

/// Accelerations x'' = f(x) as power series in time, for methods that want more of them than
/// values. All places are one vector, in the order of the system's first drifted part.
class ForceSeries {
 public:
  virtual ~ForceSeries() = default;

  /// What is felt along x(t) = sum_k path[k] t^k: f(x(t)) = sum_k force[k] t^k, and the derivatives
  /// of f by places there, sum_k derivative[k] t^k. The caller chooses how many coefficients of
  /// each it wants, by the sizes of the spans.
  virtual void expand(std::span<const Eigen::VectorXd> path, std::span<Eigen::VectorXd> force,
                      std::span<Eigen::MatrixXd> derivative) = 0;

  /// How much the equation of each place counts where errors of all are squared and added, > 0.
  /// With the masses, total momentum stays out of the forces' errors.
  virtual Eigen::VectorXd weights() const = 0;
};

}  // namespace mote
