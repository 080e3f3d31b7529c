#include "mote/models/vortex_space_moments.hpp"

#include <Eigen/Geometry>

#include "mote/models/fixed_sum.hpp"

namespace mote {

double SpaceVortexMoments::radius() const {
  const Vec<3> about_centre = impulse - 0.5 * centre().cross(circulation);
  return 2 * about_centre.norm() / magnitude;
}

SpaceVortexMoments space_vortex_moments(const VortexParticles<3>& vortices,
                                        const std::function<bool(Index)>& counts) {
  const auto at = [](std::span<const double> values, Index i) {
    return Vec<3>(Vec<3>::Map(values.data() + std::ptrdiff_t{i} * 3));
  };
  const auto sum = [&](auto zero, auto term) {
    return fixed_sum(vortices.count(), zero, [&](Index i) {
      if (counts && !counts(i)) return zero;
      return decltype(zero)(term(vortices.place(i), at(vortices.circulation(), i)));
    });
  };
  using V = const Vec<3>&;
  const Vec<3> zero = Vec<3>::Zero();
  SpaceVortexMoments m;
  m.circulation = sum(zero, [](V, V alpha) { return alpha; });
  m.magnitude = sum(0.0, [](V, V alpha) { return alpha.norm(); });
  m.impulse = sum(zero, [](V x, V alpha) -> Vec<3> { return 0.5 * x.cross(alpha); });
  m.impulse_scale = sum(0.0, [](V x, V alpha) { return 0.5 * x.norm() * alpha.norm(); });
  m.angular_impulse = sum(zero, [](V x, V alpha) -> Vec<3> { return x.cross(x.cross(alpha)) / 3; });
  m.angular_scale = sum(0.0, [](V x, V alpha) { return x.squaredNorm() * alpha.norm() / 3; });
  m.first = sum(zero, [](V x, V alpha) -> Vec<3> { return alpha.norm() * x; });
  return m;
}

}  // namespace mote
