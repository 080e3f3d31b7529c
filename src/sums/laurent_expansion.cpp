#include "mote/sums/laurent_expansion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mote/sums/complex_lanes.hpp"

namespace mote {
namespace {

using Complex = std::complex<double>;

/// The largest ratio a/(d - b) at which pairs are far: nearer ones would cost more terms than they
/// save pairs of points.
constexpr double largest_ratio = 0.5;
constexpr std::size_t most_terms = 64;

}  // namespace

LaurentExpansion::LaurentExpansion(double tolerance, bool with_potential)
    : with_potential_(with_potential),
      degrees_(tolerance, largest_ratio, most_terms),
      degree_(static_cast<std::size_t>(degrees_.degree())),
      stride_(packs_for(degree_) * lane_count) {
  fill_binomials();
}

void LaurentExpansion::fill_binomials() {
  sums_.assign(stride_ * stride_, 0);
  subsets_.assign(stride_ * stride_, 0);
  lower_subsets_.assign(stride_ * stride_, 0);
  for (std::size_t k = 0; k < stride_; ++k)
    for (std::size_t l = 0; l < stride_; ++l) {
      double* sum = &sums_[k * stride_ + l];
      *sum = k == 0 || l == 0 ? 1 : sum[-1] + sum[-static_cast<std::ptrdiff_t>(stride_)];
    }
  for (std::size_t k = 0; k < stride_; ++k)
    for (std::size_t l = k; l < stride_; ++l)
      subsets_[k * stride_ + l] = lower_subsets_[l * stride_ + k] = sums_[k * stride_ + l - k];
}

void LaurentExpansion::add_points(const PointTree<2>& tree, Index n,
                                  std::span<const double* const> strengths, double* series) const {
  const TreeNode<2>& node = tree.node(n);
  const double scale = 1 / node.radius;
  const auto end = static_cast<std::size_t>(node.points.end);
  std::array<ComplexLanes, most_terms> moments;
  std::fill_n(moments.begin(), degree_, ComplexLanes{0, 0});
  for (auto i = static_cast<std::size_t>(node.points.begin); i < end; i += lane_count) {
    const auto in_node = [&](const Lanes& lanes) { return first_lanes(lanes, end - i); };
    ComplexLanes term{in_node(load(strengths[0] + i)), 0};
    if (strengths.size() > 1) term.imaginary = in_node(load(strengths[1] + i));
    const ComplexLanes tau{in_node(load(&tree.positions()[0][i]) - node.centre[0]) * scale,
                           in_node(load(&tree.positions()[1][i]) - node.centre[1]) * scale};
    for (std::size_t k = 0; k < degree_; ++k, term *= tau) {
      moments[k].real += term.real;
      moments[k].imaginary += term.imaginary;
    }
  }
  for (std::size_t k = 0; k < degree_; ++k) {
    series[k] += sum_of(moments[k].real);
    series[stride_ + k] += sum_of(moments[k].imaginary);
  }
}

void LaurentExpansion::shift_up(std::span<const Child<2>> children, const TreeNode<2>& parent,
                                double* to) const {
  for (const Child<2>& child : children) shift_one_up(child, parent, to);
}

/// M'_l = sum_k<=l C(l, k) (delta/A)^(l-k) (a/A)^k M_k, delta from the parent's centre to the
/// child's.
void LaurentExpansion::shift_one_up(const Child<2>& child, const TreeNode<2>& parent,
                                    double* to) const {
  const Vec<2> delta = (child.node.centre - parent.centre) / parent.radius;
  std::array<double, 4 * most_terms> power{};  // with zeros for the negative ones
  double* positive = power.data() + stride_;
  list_powers({delta[0], delta[1]}, stride_ / lane_count, 2 * stride_, positive);
  double factor = 1;
  for (std::size_t k = 0; k < degree_; ++k, factor *= child.node.radius / parent.radius) {
    const Lanes real = factor * child.series[k], imaginary = factor * child.series[stride_ + k];
    for (std::size_t l = k / lane_count * lane_count; l < stride_; l += lane_count) {
      const Lanes binomial = load(&subsets_[k * stride_ + l]);
      const Lanes x = load(positive + l - k) * binomial;
      const Lanes y = load(positive + 2 * stride_ + l - k) * binomial;
      store(load(to + l) + (x * real - y * imaginary), to + l);
      store(load(to + stride_ + l) + (x * imaginary + y * real), to + stride_ + l);
    }
  }
}

void LaurentExpansion::translate(std::span<const FarPair<2>> pairs, double target_radius,
                                 double* taylor) const {
  for (const FarPair<2>& pair : pairs) translate_one(pair, target_radius, taylor);
}

/// The real part of sum_j v_j ln(d - a tau_j) = M_0 ln d - sum_k>0 M_k (a/d)^k/k, v_j real.
double LaurentExpansion::potential_of(const FarPair<2>& pair, const Complex& ratio) const {
  double sum = pair.series[0] * std::log(Vec<2>::Map(pair.distance.data()).norm());
  Complex power = ratio;
  for (int k = 1; k < pair.degree; ++k, power *= ratio)
    sum -= (pair.series[k] * power.real() -
            pair.series[stride_ + static_cast<std::size_t>(k)] * power.imag()) /
           k;
  return sum;
}

/// The series of a far node times the powers of `ratio`: (a/d)^k M_k.
void LaurentExpansion::scale(const FarPair<2>& pair, const Complex& ratio, double* scaled) const {
  ComplexLanes power = powers(1, ratio);
  const Complex step = eighth_power(ratio);
  for (std::size_t k = 0; k < static_cast<std::size_t>(pair.degree);
       k += lane_count, power *= step) {
    ComplexLanes term{load(pair.series + k), load(pair.series + stride_ + k)};
    term *= power;
    store(term.real, scaled + k);
    store(term.imaginary, scaled + most_terms + k);
  }
}

/// Adds terms first, first z, first z^2, ... times sum_k C(k + l, k) scaled_k, l from `row` on, to
/// a Taylor series: `Packs` packs of them side by side in registers.
template <std::size_t Packs>
void LaurentExpansion::add_rows(std::size_t row, std::size_t degree, const double* scaled,
                                const Complex& first, const Complex& z, double* taylor) const {
  std::array<Lanes, Packs> real, imaginary;
  real.fill(0);
  imaginary.fill(0);
  const double* column = &sums_[row];
  for (std::size_t k = 0; k < degree; ++k, column += stride_)
    unrolled<Packs>([&](auto pack) __attribute__((always_inline)) {
      const Lanes binomial = load(column + pack * lane_count);
      real[pack] += binomial * scaled[k];
      imaginary[pack] += binomial * scaled[most_terms + k];
    });
  ComplexLanes power = powers(first, z);
  const Complex step = eighth_power(z);
  unrolled<Packs>([&](auto pack) __attribute__((always_inline)) {
    ComplexLanes sum{real[pack], imaginary[pack]};
    sum *= power;
    power *= step;
    double* to = taylor + row + pack * lane_count;
    store(load(to) + sum.real, to);
    store(load(to + stride_) + sum.imaginary, to + stride_);
  });
}

/// L_l += (-b/d)^l/d sum_k C(k + l, k) (a/d)^k M_k.
void LaurentExpansion::translate_one(const FarPair<2>& pair, double target_radius,
                                     double* taylor) const {
  const Complex inverse = 1.0 / Complex(pair.distance[0], pair.distance[1]);
  const Complex ratio = pair.radius * inverse, back = -target_radius * inverse;
  std::array<double, 2 * most_terms> scaled;
  scale(pair, ratio, scaled.data());
  const auto degree = static_cast<std::size_t>(pair.degree);
  Complex first = inverse;
  std::size_t row = 0;
  for (; row + 3 * lane_count < degree; row += 4 * lane_count) {
    add_rows<4>(row, degree, scaled.data(), first, back, taylor);
    const Complex eighth = eighth_power(back), sixteenth = eighth * eighth;
    first *= sixteenth * sixteenth;
  }
  switch (packs_for(degree - std::min(row, degree))) {
    case 3:
      add_rows<3>(row, degree, scaled.data(), first, back, taylor);
      break;
    case 2:
      add_rows<2>(row, degree, scaled.data(), first, back, taylor);
      break;
    case 1:
      add_rows<1>(row, degree, scaled.data(), first, back, taylor);
      break;
    default:
      break;
  }
  if (with_potential_) taylor[2 * stride_] += potential_of(pair, ratio);
}

void LaurentExpansion::shift_down(const TreeNode<2>& parent, const double* from,
                                  std::span<const Child<2>> children) const {
  for (const Child<2>& child : children) shift_one_down(parent, from, child);
}

/// L'_l = (b/B)^l sum_k>=l C(k, l) (delta/B)^(k-l) L_k, delta from the parent's centre to the
/// child's.
void LaurentExpansion::shift_one_down(const TreeNode<2>& parent, const double* from,
                                      const Child<2>& child) const {
  const Vec<2> shift = (child.node.centre - parent.centre) / parent.radius;
  const Complex delta(shift[0], shift[1]);
  std::array<double, 2 * most_terms> power;
  list_powers(delta, stride_ / lane_count, most_terms, power.data());
  std::array<double, 4 * most_terms> reversed{};  // delta^(k - l) for l going up
  for (std::size_t k = 0; k < stride_; ++k) {
    reversed[stride_ - 1 - k] = power[k];
    reversed[2 * most_terms + stride_ - 1 - k] = power[most_terms + k];
  }
  std::array<double, 2 * most_terms> moved{};
  for (std::size_t k = 0; k < degree_; ++k) {
    const Lanes real = from[k], imaginary = from[stride_ + k];
    for (std::size_t l = 0; l <= k; l += lane_count) {
      const double* back = &reversed[stride_ - 1 - k + l];
      const Lanes binomial = load(&lower_subsets_[k * stride_ + l]);
      const Lanes x = load(back) * binomial, y = load(back + 2 * most_terms) * binomial;
      store(load(&moved[l]) + (x * real - y * imaginary), &moved[l]);
      store(load(&moved[most_terms + l]) + (x * imaginary + y * real), &moved[most_terms + l]);
    }
  }
  double factor = 1;
  for (std::size_t l = 0; l < degree_; ++l, factor *= child.node.radius / parent.radius) {
    child.series[l] += factor * moved[l];
    child.series[stride_ + l] += factor * moved[most_terms + l];
  }
  if (with_potential_) shift_integral(delta, parent.radius, from, child.series);
}

/// The constant of integration at the child's centre.
void LaurentExpansion::shift_integral(const Complex& delta, double radius, const double* from,
                                      double* to) const {
  double& constant = to[2 * stride_];
  constant += from[2 * stride_];
  Complex power = radius * delta;
  for (std::size_t l = 0; l < degree_; ++l, power *= delta)
    constant +=
        (from[l] * power.real() - from[stride_ + l] * power.imag()) / static_cast<double>(l + 1);
}

LaurentExpansion::Values LaurentExpansion::values(const double* taylor, const Lanes& x,
                                                  const Lanes& y, bool with_slope) const {
  const ComplexLanes zeta{x, y};
  ComplexLanes f{0, 0}, slope{0, 0}, integral{0, 0};
  for (std::size_t l = degree_; l-- > 0;) {
    if (with_slope) {
      slope *= zeta;
      slope.real += f.real;
      slope.imaginary += f.imaginary;
    }
    f *= zeta;
    f.real += taylor[l];
    f.imaginary += taylor[stride_ + l];
    if (with_potential_) {
      integral *= zeta;
      integral.real += taylor[l] / static_cast<double>(l + 1);
      integral.imaginary += taylor[stride_ + l] / static_cast<double>(l + 1);
    }
  }
  if (with_potential_) integral *= zeta;
  return {f.real, f.imaginary, slope.real, slope.imaginary, integral.real};
}

}  // namespace mote
