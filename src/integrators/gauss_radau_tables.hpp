#pragma once

#include <array>
#include <cstddef>

namespace mote {

/// Collocation at the eight nodes of Gauss and Radau in a step from 0 to 1, the first of which is
/// its start (Everhart 1985). The method knows accelerations by their differences G_k from that at
/// the start, at the seven other nodes: a(s) = a(0) + sum_k G_k L_k(s), with Lagrange's
/// polynomials L_k of degree 7, L_k(0) = 0.
namespace gauss_radau {

inline constexpr std::size_t nodes = 7;
using Row = std::array<double, nodes>;
using Table = std::array<Row, nodes>;

/// Roots of (P_7(x) + P_8(x))/(1 + x), x = 2 s - 1, with Legendre's polynomials; found with 40
/// digits. All that follows belongs to these numbers as they are rounded: a quadrature whose
/// weights belong to other nodes, by a rounding, makes the energy drift.
inline constexpr Row node{0.05626256053692214646565219103231, 0.18024069173689236498757994280918,
                          0.35262471711316963737390777017124, 0.54715362633055538300144855765235,
                          0.73421017721541053152321060830661, 0.88532094683909576809035976293249,
                          0.97752061356128750189117450042915};

namespace detail {

/// Of s^1 to s^7.
using Powers = std::array<long double, nodes>;

/// Coefficients of the product over i != k of (s - node_i), times s, over its value at node k.
constexpr Powers lagrange(std::size_t k) {
  std::array<long double, nodes + 1> product{1};
  long double at_node = node[k];
  for (std::size_t i = 0, degree = 0; i < nodes; ++i) {
    if (i == k) continue;
    const long double root = node[i];
    ++degree;
    for (std::size_t power = degree; power > 0; --power)
      product[power] = product[power - 1] - root * product[power];
    product[0] *= -root;
    at_node *= node[k] - root;
  }
  Powers coefficients{};
  for (std::size_t power = 0; power < nodes; ++power)
    coefficients[power] = product[power] / at_node;
  return coefficients;
}

/// L_k(s), as the product that it is: exact to roundings.
constexpr long double lagrange_at(std::size_t k, long double s) {
  long double value = s / node[k];
  for (std::size_t i = 0; i < nodes; ++i)
    if (i != k) value *= (s - node[i]) / (static_cast<long double>(node[k]) - node[i]);
  return value;
}

/// Gauss and Legendre's nodes and weights on (0, 1), exact up to degree 9.
struct QuadraturePoint {
  long double place, weight;
};
inline constexpr std::array<QuadraturePoint, 5> quadrature{{
    {0.04691007703066800360118656085030L, 0.11846344252809454375713202035996L},
    {0.23076534494715845448184278964990L, 0.23931433524968323402064575741782L},
    {0.5L, 0.28444444444444444444444444444444L},
    {0.76923465505284154551815721035010L, 0.23931433524968323402064575741782L},
    {0.95308992296933199639881343914970L, 0.11846344252809454375713202035996L},
}};

/// The integral of L_k(s) (1 - s/end)^times over s from 0 to `end`, over `end`: without the
/// cancellation among the powers.
constexpr long double mean(std::size_t k, long double end, int times) {
  long double sum = 0;
  for (const QuadraturePoint& point : quadrature)
    sum += point.weight * lagrange_at(k, end * point.place) * (times == 1 ? 1 - point.place : 1);
  return sum;
}

}  // namespace detail

/// A row of weights in two parts: numbers that double precision has, and what it leaves out.
struct Weights {
  Row weight{}, rest{};
};

template <class Weight>
constexpr Weights weights(Weight weight) {
  Weights made;
  for (std::size_t k = 0; k < nodes; ++k) {
    const long double exact = weight(k);
    made.weight[k] = static_cast<double>(exact);
    made.rest[k] = static_cast<double>(exact - made.weight[k]);
  }
  return made;
}

template <class Entry>
constexpr Table table(Entry entry) {
  Table made{};
  for (std::size_t i = 0; i < nodes; ++i)
    for (std::size_t k = 0; k < nodes; ++k) made[i][k] = static_cast<double>(entry(i, k));
  return made;
}

/// v(1) = v + h (a + sum_k of G_k), x(1) = x + h v + h^2 (a/2 + sum_k of G_k).
inline constexpr Weights to_velocity = weights([](std::size_t k) { return detail::mean(k, 1, 0); });
inline constexpr Weights to_place = weights([](std::size_t k) { return detail::mean(k, 1, 1); });

/// x at node i = x + c h v + h^2 (c^2/2 a + sum_k node_place[i][k] G_k).
inline constexpr Table node_place = table([](std::size_t i, std::size_t k) {
  const long double c = node[i];
  return c * c * detail::mean(k, c, 1);
});

/// What a correction of G_i makes of G_k at a later node: the correction is a multiple of
/// s (s - node_1) ... (s - node_(i-1)), which leaves the nodes before alone (Everhart 1985).
inline constexpr Table carried = table([](std::size_t i, std::size_t k) {
  long double part = k < i ? 0.0L : static_cast<long double>(node[k]) / node[i];
  for (std::size_t j = 0; j < i && k >= i; ++j)
    part *= (static_cast<long double>(node[k]) - node[j]) /
            (static_cast<long double>(node[i]) - node[j]);
  return part;
});

/// Coefficients of s^1 to s^7 in L_k: power[m][k].
inline constexpr Table power =
    table([](std::size_t m, std::size_t k) { return detail::lagrange(k)[m]; });

/// The same about the end of the step, L_k(1 + s) - L_k(1) = sum_m power_at_end[m][k] s^(m+1).
inline constexpr Table power_at_end = table([](std::size_t m, std::size_t k) {
  const detail::Powers from = detail::lagrange(k);
  long double sum = 0, binomial = 1;
  for (std::size_t n = m; n < nodes; ++n) {
    sum += binomial * from[n];
    binomial = binomial * static_cast<long double>(n + 2) / static_cast<long double>(n + 1 - m);
  }
  return sum;
});

/// a(1) = a + sum_k of G_k.
inline constexpr Row to_end =
    weights([](std::size_t k) { return detail::lagrange_at(k, 1); }).weight;

}  // namespace gauss_radau
}  // namespace mote
