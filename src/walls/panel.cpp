#include "mote/walls/panel.hpp"

#include <numbers>

namespace mote {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// 2 artanh q to its 13th power: ln((w + d)/(w - d)) for q = d/w.
Complex series(Complex q) {
  const Complex q2 = q * q;
  Complex sum = 1.0 / 13;
  for (const int odd : {11, 9, 7, 5, 3, 1}) sum = sum * q2 + 1.0 / odd;
  return 2.0 * q * sum;
}

/// The integral of ln over the path, w ln w - w, its branch cut opposite to `ahead`. The second
/// term is left out: it cancels in the difference that is taken.
Complex integral_of_log(Complex w, Complex ahead) {
  return w == Complex{} ? w : w * std::log(w / ahead);
}

}  // namespace

Complex sight_of(const Panel& panel, Complex place) {
  const Complex offset = place - panel.middle(), half = 0.5 * (panel.to - panel.from);
  if (std::norm(half) < reach_of_sight_series * std::norm(offset))
    return series(half * std::conj(offset) / std::norm(offset));
  return std::log((place - panel.from) * std::conj(place - panel.to) / std::norm(place - panel.to));
}

Complex velocity_of_sheet(const Panel& panel, Complex place) {
  const Complex sight = sight_of(panel, place) * std::conj(panel.tangent());
  return std::conj(Complex(sight.imag(), -sight.real())) / two_pi;
}

double circulation_of_vortex(const Panel& on, Complex place) {
  return -sight_of(on, place).imag() / two_pi;
}

double circulation_of_sheet(const Panel& on, const Panel& of) {
  const Complex ahead = on.middle() - of.middle();
  const auto difference = [&](Complex end) {
    return integral_of_log(end - of.from, ahead) - integral_of_log(end - of.to, ahead);
  };
  return ((difference(on.to) - difference(on.from)) / of.tangent()).imag() / two_pi;
}

}  // namespace mote
