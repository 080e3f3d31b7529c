#include "mote/walls/panel_sums.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "mote/operators/differential/lanes.hpp"

namespace mote {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// Places by eights; the last pack is filled up with its first place, at no strength.
struct Pack {
  Lanes x, y, strength;
  std::array<Complex, lane_count> place;
};

std::vector<Pack> packs_of(std::span<const Complex> places, std::span<const double> strength) {
  std::vector<Pack> packs(packs_for(places.size()));
  for (std::size_t k = 0; k < packs.size() * lane_count; ++k) {
    const bool exists = k < places.size();
    Pack& pack = packs[k / lane_count];
    const Complex place = places[exists ? k : k / lane_count * lane_count];
    pack.place[k % lane_count] = place;
    pack.x[k % lane_count] = place.real();
    pack.y[k % lane_count] = place.imag();
    pack.strength[k % lane_count] = exists && !strength.empty() ? strength[k] : 0;
  }
  return packs;
}

/// `sight_of` eight places at a time.
struct Sights {
  Lanes logarithm, angle;
};

Sights sights_of(const Panel& panel, const Pack& pack) {
  const Complex middle = panel.middle(), half = 0.5 * (panel.to - panel.from);
  const Lanes x = pack.x - middle.real(), y = pack.y - middle.imag(), square = x * x + y * y;
  const Lanes scale = 1 / square;
  const Lanes a = (half.real() * x + half.imag() * y) * scale;  // q = a + ib
  const Lanes b = (half.imag() * x - half.real() * y) * scale;
  const Lanes c = a * a - b * b, d = 2 * a * b;  // its square
  Lanes real = 1.0 / 13, imag = 0;
  for (const double term : {1.0 / 11, 1.0 / 9, 1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0}) {
    const Lanes next = real * c - imag * d + term;
    imag = real * d + imag * c;
    real = next;
  }
  Sights sights{2 * (a * real - b * imag), 2 * (a * imag + b * real)};
  const auto is_near = square * reach_of_sight_series <= std::norm(half);
  if (any_of(is_near))
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      if (is_near[lane]) {
        const Complex sight = sight_of(panel, pack.place[lane]);
        sights.logarithm[lane] = sight.real();
        sights.angle[lane] = sight.imag();
      }
  return sights;
}

}  // namespace

void add_circulations(std::span<const Panel> panels, const Vortices& vortices,
                      std::span<double> result) {
  const std::vector<Pack> packs = packs_of(vortices.place, vortices.circulation);
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < panels.size(); ++k) {
    Lanes sum = 0;
    for (const Pack& pack : packs) sum += pack.strength * sights_of(panels[k], pack).angle;
    result[k] -= sum_of(sum) / two_pi;
  }
}

void add_sheet_velocities(std::span<const Panel> panels, std::span<const double> strength,
                          std::span<const Complex> places, std::span<Complex> velocity) {
  const std::vector<Pack> packs = packs_of(places, {});
  std::vector<Complex> factor(panels.size());  // u - iv = sight factor/i
  for (std::size_t k = 0; k < panels.size(); ++k)
    factor[k] = strength[k] / two_pi * std::conj(panels[k].tangent());
#pragma omp parallel for schedule(static)
  for (std::size_t n = 0; n < packs.size(); ++n) {
    Lanes u = 0, v = 0;
    for (std::size_t k = 0; k < panels.size(); ++k) {
      const auto [logarithm, angle] = sights_of(panels[k], packs[n]);
      u += logarithm * factor[k].imag() + angle * factor[k].real();
      v += logarithm * factor[k].real() - angle * factor[k].imag();
    }
    const std::size_t first = n * lane_count, end = std::min(first + lane_count, places.size());
    for (std::size_t i = first; i < end; ++i) velocity[i] += Complex(u[i - first], v[i - first]);
  }
}

}  // namespace mote
