#pragma once

#include <cstdint>
#include <span>

#include "mote/integrators/force_series.hpp"

namespace mote {

/// The gravity of point masses as a power series along a path: with d the separation of a pair,
///   a_i = sum of -G m_j d / |d|^D,
/// D = 3 in space and D = 2 in the plane (potential m ln r).
template <int D>
class GravitySeries final : public ForceSeries {
 public:
  GravitySeries(double gravitational_constant, std::span<const double> mass)
      : gravitational_constant_(gravitational_constant), mass_(mass) {}

  void expand(std::span<const Eigen::VectorXd> path, std::span<Eigen::VectorXd> force,
              std::span<Eigen::MatrixXd> derivative) override;

  /// The masses. A body without mass counts so little that it does not act on the others.
  Eigen::VectorXd weights() const override;

  /// Times that series were formed.
  std::int64_t expansions() const { return expansions_; }

 private:
  double gravitational_constant_;
  std::span<const double> mass_;
  std::int64_t expansions_ = 0;
};

extern template class GravitySeries<2>;
extern template class GravitySeries<3>;

}  // namespace mote
