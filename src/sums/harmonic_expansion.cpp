#include "mote/sums/harmonic_expansion.hpp"

#include <algorithm>

namespace mote {
namespace {

using DegreeLanes = std::array<Lanes, 2 * highest_degree + 1>;

/// Matrices along the axis take so many outputs at a time, of the cosines and of the sines.
constexpr int outputs_at_once = 4;

/// Coefficients of one order: those of the cosines, then those of the sines.
template <int rows, bool sines>
[[gnu::always_inline]] inline void inward_rows(const double* matrix, std::size_t row_length,
                                               std::size_t degrees, const Lanes* in, Lanes* out) {
  Lanes even[rows], odd[rows];
  for (int l = 0; l < rows; ++l) {
    even[l] = matrix[l] * in[0];
    if constexpr (sines) odd[l] = matrix[l] * in[degrees];
  }
  for (std::size_t n = 1; n < degrees; ++n) {
    matrix += row_length;
    const Lanes c = in[n], s = sines ? in[degrees + n] : c;
#pragma GCC unroll 8
    for (int l = 0; l < rows; ++l) {
      const Lanes factor = matrix[l];
      even[l] += factor * c;
      if constexpr (sines) odd[l] += factor * s;
    }
  }
  for (int l = 0; l < rows; ++l) {
    out[l] = even[l];
    if constexpr (sines) out[static_cast<std::size_t>(l) + degrees] = odd[l];
  }
}

template <bool sines>
void inward_order(int order, std::size_t degrees, const Lanes* in, Lanes* out) {
  const double* matrix = harmonic_tables().outward_to_inward(order);
  const std::size_t row_length = HarmonicTables::row_length(order);
  std::size_t l = 0;
  for (; l + outputs_at_once <= degrees; l += outputs_at_once)
    inward_rows<outputs_at_once, sines>(matrix + l, row_length, degrees, in, out + l);
  for (; l + 2 <= degrees; l += 2)
    inward_rows<2, sines>(matrix + l, row_length, degrees, in, out + l);
  if (l < degrees) inward_rows<1, sines>(matrix + l, row_length, degrees, in, out + l);
}

/// Multipole to local where the target is along +z, without powers of radii and distance.
void turn_inward(int degree, const Lanes* in, Lanes* out) {
  inward_order<false>(0, degrees_of(degree, 0), in, out);
  for (int m = 1; m <= degree; ++m) {
    const std::size_t place = by_order(degree, m);
    inward_order<true>(m, degrees_of(degree, m), in + place, out + place);
  }
}

/// Calls part(matrix, row length, degrees, place) for the cosines and the sines of each order.
template <class Part>
void for_each_order(int degree, const Part& part) {
  for (int m = 0; m <= degree; ++m) {
    const double* matrix = harmonic_tables().change_of_centre(m);
    const std::size_t degrees = degrees_of(degree, m), place = by_order(degree, m);
    part(matrix, HarmonicTables::row_length(m), degrees, place);
    if (m > 0) part(matrix, HarmonicTables::row_length(m), degrees, place + degrees);
  }
}

/// The centre of a multipole moves along -z: `powers` of the length that it moves.
void move_multipole(int degree, const Lanes* powers, const Lanes* in, Lanes* out) {
  for_each_order(degree, [&](const double* matrix, std::size_t row_length, std::size_t degrees,
                             std::size_t place) {
    for (std::size_t l = 0; l < degrees; ++l) {
      Lanes sum = in[place + l];
      for (std::size_t n = 0; n < l; ++n)
        sum += matrix[n * row_length + l] * powers[l - n] * in[place + n];
      out[place + l] = sum;
    }
  });
}

/// The centre of a local expansion moves along +z.
void move_local(int degree, const Lanes* powers, const Lanes* in, Lanes* out) {
  for_each_order(degree, [&](const double* matrix, std::size_t row_length, std::size_t degrees,
                             std::size_t place) {
    for (std::size_t n = 0; n < degrees; ++n) {
      Lanes sum = in[place + n];
      for (std::size_t l = n + 1; l < degrees; ++l)
        sum += matrix[n * row_length + l] * powers[l - n] * in[place + l];
      out[place + n] = sum;
    }
  });
}

/// 0 where the divisor is: the power 0 of it is all that counts then.
Vector3 difference(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
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

/// One component, in axes along its displacements and multiplied by powers of `ratio`.
void HarmonicExpansion::turn_in(const Batch& batch, int component, const Lanes& ratio) {
  DegreeLanes gathered, turned;
  Lanes power = 1;
  for (int n = 0; n <= batch.degree; ++n) {
    const std::size_t first = place_of(component) + cosine_place(n, 0);
    for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(n) + 1; ++i)
      gathered[i] = Lanes([&](auto lane) { return batch.coefficients[lane][first + i]; });
    turn_to_axis(n, turn_, gathered.data(), turned.data());
    for (int m = 0; m <= n; ++m) {
      Lanes* to = &along_axis_[by_order(batch.degree, m) + static_cast<std::size_t>(n - m)];
      to[0] = power * turned[static_cast<std::size_t>(m)];
      if (m > 0) to[degrees_of(batch.degree, m)] = power * turned[static_cast<std::size_t>(n + m)];
    }
    power *= ratio;
  }
}

/// Calls add(place, lanes) for every coefficient, in the axes of the coordinates and multiplied by
/// `first` and powers of `ratio`.
template <class Add>
void HarmonicExpansion::turn_out(int degree, int component, const Lanes& first, const Lanes& ratio,
                                 const Add& add) {
  DegreeLanes gathered, turned;
  Lanes power = first;
  for (int l = 0; l <= degree; ++l) {
    for (int m = 0; m <= l; ++m) {
      const Lanes* from = &translated_[by_order(degree, m) + static_cast<std::size_t>(l - m)];
      gathered[static_cast<std::size_t>(m)] = from[0];
      if (m > 0) gathered[static_cast<std::size_t>(l + m)] = from[degrees_of(degree, m)];
    }
    turn_from_axis(l, turn_, gathered.data(), turned.data());
    const std::size_t place = place_of(component) + cosine_place(l, 0);
    for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(l) + 1; ++i)
      add(place + i, power * turned[i]);
    power *= ratio;
  }
}

void HarmonicExpansion::add_to_sums(int degree, int component, const Lanes& first,
                                    const Lanes& ratio) {
  turn_out(degree, component, first, ratio,
           [&](std::size_t place, const Lanes& value) { sums_[place] += value; });
}

void HarmonicExpansion::prepare_powers(const Lanes& ratio) {
  powers_[0] = 1;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(degree_); ++n)
    powers_[n] = powers_[n - 1] * ratio;
}

/// A counting sort, stable.
void HarmonicExpansion::sort_by_degree(std::span<const DistantSource> sources) {
  std::array<std::uint32_t, highest_degree + 2> begin{};
  for (const DistantSource& source : sources)
    ++begin[static_cast<std::size_t>(degree_ - source.degree + 1)];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  if (order_.size() < sources.size()) order_.resize(sources.size());
  for (std::uint32_t i = 0; i < sources.size(); ++i)
    order_[begin[static_cast<std::size_t>(degree_ - sources[i].degree)]++] = i;
}

void HarmonicExpansion::translate(std::span<const DistantSource> sources, double radius,
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
      const DistantSource& source = sources[order_[first + lane]];
      batch.put(lane, source.multipole, source.displacement, source.radius);
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
    add_to_sums(batch.degree, c, batch.strength / turn_.distance, target_radius / turn_.distance);
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
      add_to_sums(degree_, c, batch.strength, 1);
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
    turn_.prepare(degree_, batch.displacement);
    prepare_powers(turn_.distance / parent.radius);
    for (int c = 0; c < components_; ++c) {
      turn_in(batch, c, 1);
      move_local(degree_, powers_.data(), along_axis_.data(), translated_.data());
      turn_out(degree_, c, 1, batch.radius / parent.radius,
               [&](std::size_t place, const Lanes& value) {
                 for (std::size_t lane = 0; lane < count; ++lane)
                   children[first + lane].local[place] += value[lane];
               });
    }
  }
}

}  // namespace mote
