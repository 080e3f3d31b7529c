#include "mote/sums/harmonic_expansion.hpp"

#include <algorithm>

#include "mote/sums/harmonic_axis.hpp"

namespace mote {
namespace {

using DegreeLanes = std::array<Lanes, 2 * highest_degree + 1>;

Vector3 difference(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// 0 where the divisor is: only the power 0 counts then.
Lanes ratio_of(const Lanes& length, double radius) { return radius > 0 ? length / radius : 0; }

}  // namespace

/// Eight expansions and how far each of them is to be moved.
struct HarmonicExpansion::Batch {
  int degree = 0;
  std::array<const double*, lane_count> coefficients;
  std::array<Lanes, 3> displacement;
  Lanes radius, strength = 0;  ///< strength 1, and 0 of what fills up the last batch

  void put(std::size_t lane, const double* expansion, const Vector3& moved, double radius_of_it) {
    coefficients[lane] = expansion;
    for (std::size_t d = 0; d < 3; ++d) displacement[d][lane] = moved[d];
    radius[lane] = radius_of_it;
    strength[lane] = 1;
  }
  /// Lanes from `count` on repeat the first, with strength 0.
  void fill_from(std::size_t count) {
    for (std::size_t lane = count; lane < lane_count; ++lane) {
      put(lane, coefficients[0], {displacement[0][0], displacement[1][0], displacement[2][0]},
          radius[0]);
      strength[lane] = 0;
    }
  }
};

HarmonicExpansion::HarmonicExpansion(int degree, int components)
    : degree_(degree), components_(components) {
  along_axis_.resize(harmonic_count(degree));
  translated_.resize(harmonic_count(degree));
  sums_.resize(coefficients());
  strengths_.resize(static_cast<std::size_t>(components));
}

void HarmonicExpansion::clear_sums(int degree) {
  for (int c = 0; c < components_; ++c)
    std::fill_n(sums_.begin() + static_cast<std::ptrdiff_t>(place_of(c)), harmonic_count(degree),
                Lanes(0));
}

void HarmonicExpansion::add_sums(int degree, double* coefficients) {
  for (int c = 0; c < components_; ++c)
    for (std::size_t i = 0; i < harmonic_count(degree); ++i)
      coefficients[place_of(c) + i] += sum_of(sums_[place_of(c) + i]);
}

/// One component, multiplied by powers of `ratio`, in axes along the displacements.
void HarmonicExpansion::turn_in(const Batch& batch, int component, const Lanes& ratio) {
  DegreeLanes gathered;
  Lanes power = 1;
  for (int n = 0; n <= batch.degree; ++n) {
    const std::size_t place = cosine_place(n, 0), first = place_of(component) + place;
    for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(n) + 1; ++i)
      gathered[i] = power * Lanes([&](auto lane) { return batch.coefficients[lane][first + i]; });
    turn_to_axis(n, turn_, gathered.data(), &along_axis_[place]);
    power *= ratio;
  }
}

/// Adds one component to the sums, in the axes of the coordinates, multiplied by `first` and powers
/// of `ratio`.
void HarmonicExpansion::turn_out(int degree, int component, const Lanes& first,
                                 const Lanes& ratio) {
  Lanes power = first;
  for (int l = 0; l <= degree; ++l) {
    const std::size_t place = cosine_place(l, 0);
    add_turned_from_axis(l, turn_, power, &translated_[place], &sums_[place_of(component) + place]);
    power *= ratio;
  }
}

void HarmonicExpansion::prepare_powers(const Lanes& ratio) {
  powers_[0] = 1;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(degree_); ++n)
    powers_[n] = powers_[n - 1] * ratio;
}

/// A counting sort, stable.
void HarmonicExpansion::sort_by_degree(std::span<const FarPair<3>> sources) {
  std::array<std::uint32_t, highest_degree + 2> begin{};
  for (const FarPair<3>& source : sources)
    ++begin[static_cast<std::size_t>(degree_ - source.degree + 1)];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  if (order_.size() < sources.size()) order_.resize(sources.size());
  for (std::uint32_t i = 0; i < sources.size(); ++i)
    order_[begin[static_cast<std::size_t>(degree_ - sources[i].degree)]++] = i;
}

void HarmonicExpansion::translate(std::span<const FarPair<3>> sources, double radius,
                                  double* local) {
  if (sources.empty()) return;
  sort_by_degree(sources);
  const int degree = sources[order_[0]].degree;
  clear_sums(degree);
  Batch batch;
  for (std::size_t first = 0; first < sources.size(); first += lane_count) {
    const std::size_t count = std::min(lane_count, sources.size() - first);
    batch.degree = sources[order_[first]].degree;
    for (std::size_t lane = 0; lane < count; ++lane) {
      const FarPair<3>& source = sources[order_[first + lane]];
      batch.put(lane, source.series, source.distance, source.radius);
    }
    batch.fill_from(count);
    translate_batch(batch, radius);
  }
  add_sums(degree, local);
}

void HarmonicExpansion::translate_batch(const Batch& batch, const Lanes& target_radius) {
  turn_.prepare(batch.degree, batch.displacement);
  for (int c = 0; c < components_; ++c) {
    turn_in(batch, c, batch.radius / turn_.distance);
    turn_inward(batch.degree, along_axis_.data(), translated_.data());
    turn_out(batch.degree, c, batch.strength / turn_.distance, target_radius / turn_.distance);
  }
}

void HarmonicExpansion::shift_up(std::span<const ChildMultipole> children, const NodeBall& parent,
                                 double* multipole) {
  clear_sums(degree_);
  Batch batch;
  batch.degree = degree_;
  for (std::size_t first = 0; first < children.size(); first += lane_count) {
    const std::size_t count = std::min(lane_count, children.size() - first);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const auto& [coefficients, ball] = children[first + lane];
      batch.put(lane, coefficients, difference(ball.centre, parent.centre), ball.radius);
    }
    batch.fill_from(count);
    turn_.prepare(degree_, batch.displacement);
    prepare_powers(ratio_of(turn_.distance, parent.radius));
    for (int c = 0; c < components_; ++c) {
      turn_in(batch, c, ratio_of(batch.radius, parent.radius));
      move_multipole(degree_, powers_.data(), along_axis_.data(), translated_.data());
      turn_out(degree_, c, batch.strength, 1);
    }
  }
  add_sums(degree_, multipole);
}

void HarmonicExpansion::shift_down(const double* local, const NodeBall& parent,
                                   std::span<const ChildLocal> children) {
  Batch batch;
  batch.degree = degree_;
  for (std::size_t first = 0; first < children.size(); first += lane_count) {
    const std::size_t count = std::min(lane_count, children.size() - first);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const NodeBall& ball = children[first + lane].ball;
      batch.put(lane, local, difference(ball.centre, parent.centre), ball.radius);
    }
    batch.fill_from(count);
    clear_sums(degree_);
    turn_.prepare(degree_, batch.displacement);
    prepare_powers(turn_.distance / parent.radius);
    for (int c = 0; c < components_; ++c) {
      turn_in(batch, c, 1);
      move_local(degree_, powers_.data(), along_axis_.data(), translated_.data());
      turn_out(degree_, c, 1, batch.radius / parent.radius);
    }
    for (std::size_t lane = 0; lane < count; ++lane)
      for (std::size_t i = 0; i < sums_.size(); ++i)
        children[first + lane].local[i] += sums_[i][lane];
  }
}

}  // namespace mote
