#include "mote/models/vortex_moments.hpp"

#include <cmath>

#include "mote/models/fixed_sum.hpp"

namespace mote {
namespace {

Vec<2> at(std::span<const double> values, Index i) {
  return Vec<2>::Map(values.data() + std::ptrdiff_t{i} * 2);
}

}  // namespace

Mat<2> VortexMoments::spread() const {
  return second / circulation - centre() * centre().transpose();
}

bool VortexMoments::is_round() const {
  constexpr double next_to_nothing = 1e-3;
  const Mat<2> m = spread();
  return std::hypot(m(0, 0) - m(1, 1), 2 * m(0, 1)) < next_to_nothing * std::abs(m.trace());
}

double VortexMoments::axis() const {
  if (is_round()) return 0;
  const Mat<2> m = spread();
  return 0.5 * std::atan2(2 * m(0, 1), m(0, 0) - m(1, 1));
}

/// With p = m_xx - m_yy and q = 2 m_xy, the axis is atan2(q, p)/2. The centre stays: vortices do
/// not move it.
double VortexMoments::axis_rate() const {
  const Mat<2> m = spread();
  const Mat<2> rate = second_rate / circulation;
  const double p = m(0, 0) - m(1, 1), q = 2 * m(0, 1), square = p * p + q * q;
  if (is_round()) return 0;
  return 0.5 * (p * 2 * rate(0, 1) - q * (rate(0, 0) - rate(1, 1))) / square;
}

VortexMoments vortex_moments(std::span<const double> position, std::span<const double> circulation,
                             std::span<const double> velocity) {
  const auto count = static_cast<Index>(circulation.size());
  const auto sum = [&](auto zero, auto term) {
    return fixed_sum(count, zero, [&](Index i) {
      return decltype(zero)(term(circulation[static_cast<std::size_t>(i)], at(position, i), i));
    });
  };
  using V = const Vec<2>&;
  VortexMoments m;
  m.circulation = sum(0.0, [](double strength, V, Index) { return strength; });
  m.magnitude = sum(0.0, [](double strength, V, Index) { return std::abs(strength); });
  m.first = sum(m.first, [](double strength, V x, Index) -> Vec<2> { return strength * x; });
  m.first_magnitude =
      sum(0.0, [](double strength, V x, Index) { return std::abs(strength) * x.norm(); });
  m.second = sum(
      m.second, [](double strength, V x, Index) -> Mat<2> { return strength * x * x.transpose(); });
  if (velocity.empty()) return m;
  m.second_rate = sum(m.second_rate, [&](double strength, V x, Index i) -> Mat<2> {
    const Mat<2> part = strength * at(velocity, i) * x.transpose();
    return part + part.transpose();
  });
  return m;
}

}  // namespace mote
