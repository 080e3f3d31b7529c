#include "mote/models/collisions.hpp"

#include <algorithm>

namespace mote {
namespace {

/// A polynomial of degree 6 by its coefficients in Bernstein's basis, which its values lie between.
using Sextic = std::array<double, 7>;

/// Cuts a polynomial on [0, 1] at the middle (de Casteljau): `whole` becomes its upper half, and
/// the lower is returned.
Sextic lower_half_cut_from(Sextic& whole) {
  Sextic lower;
  for (std::size_t level = 0; level < whole.size(); ++level) {
    lower[level] = whole[0];
    for (std::size_t k = 0; k + 1 + level < whole.size(); ++k)
      whole[k] = 0.5 * (whole[k] + whole[k + 1]);
  }
  return lower;
}

/// The first zero in [start, start + width] of a polynomial that begins above 0.
std::optional<double> first_zero(Sextic upper, double start, double width) {
  if (std::ranges::all_of(upper, [](double coefficient) { return coefficient > 0; })) return {};
  if (width < 0x1p-50) return start;
  const Sextic lower = lower_half_cut_from(upper);
  if (const auto zero = first_zero(lower, start, width / 2)) return zero;
  return first_zero(upper, start + width / 2, width / 2);
}

template <int D>
Vec<D> difference(std::span<const double> vectors, std::size_t first, std::size_t second) {
  return Vec<D>::Map(vectors.data() + second * D) - Vec<D>::Map(vectors.data() + first * D);
}

}  // namespace

template <int D>
Approach<D>::Approach(const std::array<Vec<D>, 2>& separation, const std::array<Vec<D>, 2>& change)
    : control_{separation[0], separation[0] + change[0] / 3, separation[1] - change[1] / 3,
               separation[1]} {}

/// Coefficient k of the square is the sum over i + j = k of C(3, i) C(3, j)/C(6, k) b_i . b_j.
template <int D>
std::optional<double> Approach<D>::first_within(double distance) const {
  constexpr double choose_3[] = {1, 3, 3, 1}, choose_6[] = {1, 6, 15, 20, 15, 6, 1};
  Sextic excess;
  excess.fill(-distance * distance);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      excess[i + j] += choose_3[i] * choose_3[j] / choose_6[i + j] * control_[i].dot(control_[j]);
  return first_zero(excess, 0, 1);
}

template <int D>
Vec<D> Approach<D>::rate(double part) const {
  const double rest = 1 - part;
  return 3 * (rest * rest * (control_[1] - control_[0]) +
              2 * rest * part * (control_[2] - control_[1]) +
              part * part * (control_[3] - control_[2]));
}

template <int D>
Collisions<D>::Collisions(const std::vector<std::optional<double>>& radius) {
  for (std::size_t body = 0; body < radius.size(); ++body)
    if (radius[body]) balls_.push_back({body, *radius[body]});
}

template <int D>
std::optional<std::array<std::size_t, 2>> Collisions<D>::contact(
    std::span<const double> position) const {
  for (auto a = balls_.begin(); a != balls_.end(); ++a)
    for (auto b = std::next(a); b != balls_.end(); ++b)
      if (difference<D>(position, a->body, b->body).norm() <= a->radius + b->radius)
        return std::array{a->body, b->body};
  return std::nullopt;
}

template <int D>
void Collisions<D>::begin_step(const StepEnd& start) {
  position_.assign(start.position.begin(), start.position.end());
  velocity_.assign(start.velocity.begin(), start.velocity.end());
}

template <int D>
std::vector<Collision> Collisions<D>::end_step(double time, double step, const StepEnd& end) const {
  std::vector<Collision> found;
  for (auto a = balls_.begin(); a != balls_.end(); ++a)
    for (auto b = std::next(a); b != balls_.end(); ++b) {
      const auto of = [&](std::span<const double> vectors) {
        return difference<D>(vectors, a->body, b->body);
      };
      const double distance = a->radius + b->radius;
      if (of(position_).norm() <= distance) continue;
      const Approach<D> approach({of(position_), of(end.position)},
                                 {step * of(velocity_), step * of(end.velocity)});
      if (const auto part = approach.first_within(distance))
        found.push_back(
            {time + *part * step, a->body, b->body, approach.rate(*part).norm() / step});
    }
  std::ranges::stable_sort(found, {}, &Collision::time);
  return found;
}

template class Approach<2>;
template class Approach<3>;
template class Collisions<2>;
template class Collisions<3>;

}  // namespace mote
