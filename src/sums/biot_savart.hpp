#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "mote/sums/sum_settings.hpp"

namespace mote {

/// Where the velocity of vortices goes: D numbers a target, and, unless empty, its gradient,
/// du_a/dx_b at place D a + b of D D numbers a target.
struct VelocityField {
  std::span<double> velocity;
  std::span<double> gradient;
};

/// The velocity that vortices of circulation strength induce in an unbounded fluid, the volume
/// integral of Isshiki (2014), (38) with (39c), for q(r/core_size) of a core's circulation:
///   2D: u = sum_j Gamma_j/(2 pi) q (-y, x)/r^2
///   3D: u = sum_j 1/(4 pi) q alpha_j x r/r^3,   r = x - x_j.
/// Keeps its working memory from call to call. Results do not depend on the number of threads.
template <int D>
class BiotSavart {
 public:
  /// `core` is a name of the list VortexCores, or "point". Throws InputError for a method that has
  /// no such sum or a tolerance out of its range.
  explicit BiotSavart(const SumSettings& settings, std::string_view core = "point");
  ~BiotSavart();

  /// At the sources themselves; a vortex does not move itself.
  void at_sources(const Sources<D>& sources, const VelocityField& result);
  /// At other places. Throws InputError where a target stands on a point vortex.
  void at(std::span<const double> targets, const Sources<D>& sources, const VelocityField& result);

 private:
  class Sum;
  std::unique_ptr<Sum> sum_;
};

extern template class BiotSavart<2>;
extern template class BiotSavart<3>;

}  // namespace mote
