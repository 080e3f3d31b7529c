#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "mote/sums/sum_settings.hpp"

namespace mote {

/// Where a potential goes, one number a target, and its gradient, D numbers a target. Either may be
/// empty.
struct GravityField {
  std::span<double> potential;
  std::span<double> gradient;
};

/// The potential of masses and its gradient (the acceleration is -G times it), for q(r/core_size)
/// of a core's mass; lap phi = 2 pi rho in 2D, 4 pi rho in 3D:
///   2D: phi = sum_j m_j ln r,   grad phi = sum_j m_j q x/r^2
///   3D: phi = -sum_j m_j/r,     grad phi = sum_j m_j q x/r^3,   for points, x = x_i - x_j.
/// Keeps its working memory from call to call. Results do not depend on the number of threads.
template <int D>
class Gravity {
 public:
  /// `core` is a name of the list VortexCores, or "point". Throws InputError for a method that has
  /// no such sum or a tolerance out of its range.
  explicit Gravity(const SumSettings& settings, std::string_view core = "point");
  ~Gravity();

  /// At the sources themselves, without what each does to itself.
  void at_sources(const Sources<D>& sources, const GravityField& result);
  /// At other places. Throws InputError where a target stands on a point mass.
  void at(std::span<const double> targets, const Sources<D>& sources, const GravityField& result);

 private:
  class Sum;
  std::unique_ptr<Sum> sum_;
};

extern template class Gravity<2>;
extern template class Gravity<3>;

}  // namespace mote
