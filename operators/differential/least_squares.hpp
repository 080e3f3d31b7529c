#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/operators/differential/gram_schmidt.hpp"
#include "mote/operators/differential/monomials.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// Moving least squares: the derivatives at x_i of the polynomial of degree `Degree` through
/// (x_i, f_i) that fits the neighbours best, that is, makes
///   sum_j w_ij (sum_a c_a m_a(xi_ij) - (f_j - f_i))^2,   xi_ij = (x_j - x_i)/h_i
/// least, m_a being the monomials of degree 1 to Degree (Lancaster & Salkauskas 1981; Liszka &
/// Orkisz 1980 for the form with the value at x_i fixed). With P_ja = m_a(xi_ij) and W = diag(w),
/// a derivative e.c has the weights w_ij m(xi_ij) . C, (P^T W P) C = e. The triangular factor comes
/// from W^(1/2) P itself, with its columns scaled, not from its square. Exact for polynomials of
/// this degree at any arrangement of the points, also on one side of a boundary.
template <int D, int Degree>
class LeastSquares final : public DifferentialOperator<D> {
  static constexpr int second = second_derivatives<D>;
  static constexpr int lowest_degree = 2;

 public:
  static constexpr int highest_dimension = 3;
  static constexpr std::string_view family = "least_squares";
  static constexpr std::string_view summary =
      "moving least squares, exact for polynomials of this degree";
  static constexpr int degree = Degree;
  static constexpr int unknowns = Monomials<D, Degree>::count;

  double smoothing_length = usual_length();  ///< radius of the neighbourhood, in local spacings
  PairLength length = PairLength::mean;
  bool lower_degree = false;  ///< where the neighbours do not suffice, instead of stopping

  void describe(Description& description) override {
    describe_lengths(description, smoothing_length, length);
    description.flag(
        {"lower_degree", "take a lower degree, but at least 2, where the neighbours are too few"},
        lower_degree);
  }

  NeighbourRule neighbour_rule() const override { return {1, smoothing_length, length}; }

  void prepare(const Points<D>& points, const NeighbourLists& lists) override {
    points_ = &points;
    lists_ = &lists;
    fits_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
    for (Index i = 0; i < points.receivers; ++i) fit(i);
    for (Index i = 0; i < points.receivers; ++i)
      if (points.needs_weights(i)) refuse_bad_neighbourhood(i);
  }

  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    for_each_pack(i, [&](std::size_t first, std::size_t lanes, const Basis& basis) {
      for (int d = 0; d < D; ++d) {
        const Lanes g = combination(basis, fits_[i].gradient[d]);
        for (std::size_t k = 0; k < lanes; ++k) weights[first + k][d] = g[k];
      }
    });
  }

  void laplacian_weights(Index i, std::span<double> weights) const override {
    for_each_pack(i, [&](std::size_t first, std::size_t lanes, const Basis& basis) {
      const Lanes l = combination(basis, fits_[i].laplacian);
      for (std::size_t k = 0; k < lanes; ++k) weights[first + k] = l[k];
    });
  }

  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override {
    TriangularFactor<unknowns> factor;
    factorise(i, fits_[i].degree, factor);
    int s = 0;
    for (int c = 0; c < D; ++c)
      for (int d = c; d < D; ++d, ++s) {
        const Coefficients component = derivative(i, factor, {{D + s, c == d ? 2.0 : 1.0}}, 2);
        for_each_pack(i, [&](std::size_t first, std::size_t lanes, const Basis& basis) {
          const Lanes h = combination(basis, component);
          for (std::size_t k = 0; k < lanes; ++k)
            weights[first + k](c, d) = weights[first + k](d, c) = h[k];
        });
      }
  }

  std::vector<std::string> remarks() const override {
    const auto is_lowered = [](const Fit& fit) { return fit.degree < Degree; };
    const auto lowered = std::ranges::count_if(fits_, is_lowered);
    if (lowered == 0) return {};
    const auto first = std::ranges::find_if(fits_, is_lowered) - fits_.begin();
    return {std::to_string(lowered) + " points have neighbours that do not fix degree " +
            std::to_string(Degree) + ", the first of them point " + std::to_string(first) +
            "; a lower degree was used there"};
  }

 private:
  static constexpr Monomials<D, Degree> monomials{};
  using Basis = std::array<Lanes, unknowns>;          ///< w m(xi) of the neighbours in a pack
  using Coefficients = std::array<double, unknowns>;  ///< C

  /// What prepare() finds for a receiver.
  struct Fit {
    int degree = 0;  ///< 0 if none can be fitted
    std::array<Coefficients, D> gradient;
    Coefficients laplacian;
  };

  /// As many neighbours as there are unknowns on one side of the end of a line already.
  static constexpr double usual_length() { return Degree + 0.6; }

  /// The square root of the weight of a neighbour at q = r/h, w = (1 - q^2)^6: bell-shaped, and 0
  /// at the rim. Flatter ones have a larger error on disorder at any radius, steeper ones see too
  /// few neighbours.
  static Lanes root_of_weight(const Lanes& q_squared) {
    const Lanes inside = 1 - q_squared;
    return inside * inside * inside;
  }

  /// Calls visit(first neighbour, number of lanes used, coordinates, root of the weight) pack by
  /// pack; lanes that are not used have the weight 0.
  template <class Visit>
  void for_each_place(Index i, Visit visit) const {
    const auto list = (*lists_)[i];
    const Vec<D> centre = points_->at(i);
    for (std::size_t first = 0; first < list.size(); first += lane_count) {
      const std::size_t lanes = std::min(lane_count, list.size() - first);
      std::array<Lanes, D> xi;
      for (auto& component : xi) component = 0;
      Lanes q_squared = 1;
      for (std::size_t k = 0; k < lanes; ++k) {
        const Index j = list[first + k];
        const double scale =
            1 / (smoothing_length * pair_length(length, points_->length[i], points_->length[j]));
        const Vec<D> x = points_->at(j) - centre;
        q_squared[k] = std::min(1.0, x.squaredNorm() * scale * scale);
        for (int d = 0; d < D; ++d) xi[d][k] = x[d] / reach(i);
      }
      visit(first, lanes, xi, root_of_weight(q_squared));
    }
  }

  /// The monomials of all lanes, times `factor`.
  static void expand(const std::array<Lanes, D>& xi, const Lanes& factor, Basis& basis) {
    for (int d = 0; d < D; ++d) basis[d] = factor * xi[d];
    for (int a = D; a < unknowns; ++a)
      basis[a] = basis[monomials.parent[a]] * xi[monomials.axis[a]];
  }

  template <class Visit>
  void for_each_pack(Index i, Visit visit) const {
    for_each_place(i, [&](std::size_t first, std::size_t lanes, const auto& xi, const Lanes& root) {
      Basis basis;
      expand(xi, root * root, basis);
      visit(first, lanes, basis);
    });
  }

  static Lanes combination(const Basis& basis, const Coefficients& c) {
    Lanes sum = 0;
    for (int a = 0; a < unknowns; ++a) sum += c[a] * basis[a];
    return sum;
  }

  double reach(Index i) const { return smoothing_length * points_->length[i]; }

  /// Factorises W^(1/2) P for this degree; whether its columns are independent.
  bool factorise(Index i, int of_degree, TriangularFactor<unknowns>& factor) const {
    static thread_local std::vector<Lanes> matrix;
    const std::size_t packs = packs_for((*lists_)[i].size());
    matrix.resize(std::max(matrix.size(), packs * unknowns));
    for_each_place(i, [&](std::size_t first, std::size_t, const auto& xi, const Lanes& root) {
      Basis basis;
      expand(xi, root, basis);
      for (int a = 0; a < unknowns; ++a) matrix[a * packs + first / lane_count] = basis[a];
    });
    const int columns = monomial_count(D, of_degree);
    return static_cast<std::size_t>(columns) <= (*lists_)[i].size() &&
           factor.factorise(matrix, packs, columns) == columns;
  }

  /// The coefficients C of sum_k value_k d/dc_k, per length to the `order`.
  struct Entry {
    int unknown;
    double value;
  };
  Coefficients derivative(Index i, const TriangularFactor<unknowns>& factor,
                          std::initializer_list<Entry> entries, int order) const {
    Coefficients e{};
    for (const auto& [unknown, value] : entries) e[unknown] = value / std::pow(reach(i), order);
    return factor.solve_normal_equations(e);
  }

  void fit(Index i) {
    TriangularFactor<unknowns> factor;
    Fit& found = fits_[i];
    const int lowest = lower_degree ? lowest_degree : Degree;
    for (found.degree = Degree; found.degree >= lowest; --found.degree)
      if (factorise(i, found.degree, factor)) break;
    if (found.degree < lowest) found.degree = 0;
    if (found.degree == 0) return;
    for (int d = 0; d < D; ++d) found.gradient[d] = derivative(i, factor, {{d, 1.0}}, 1);
    if constexpr (D == 1) found.laplacian = derivative(i, factor, {{1, 2.0}}, 2);
    if constexpr (D == 2) found.laplacian = derivative(i, factor, {{2, 2.0}, {4, 2.0}}, 2);
    if constexpr (D == 3)
      found.laplacian = derivative(i, factor, {{3, 2.0}, {6, 2.0}, {8, 2.0}}, 2);
  }

  void refuse_bad_neighbourhood(Index i) const {
    if (fits_[i].degree > 0) return;
    const std::size_t neighbours = (*lists_)[i].size();
    constexpr int needed = monomial_count(D, Degree);
    throw NumericalFailure(
        "particle " + std::to_string(i) + " has " + std::to_string(neighbours) +
            " neighbours, which do not fix a polynomial of degree " + std::to_string(Degree) +
            " with " + std::to_string(needed) + " unknowns",
        {i},
        neighbours < needed ? "they are too few: a larger smoothing_length, or lower_degree, helps"
                            : "they lie on too few lines, or at the same place");
  }

  const Points<D>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;
  std::vector<Fit> fits_;
};

template <int D>
using Quadratic = LeastSquares<D, 2>;
template <int D>
using Cubic = LeastSquares<D, 3>;
template <int D>
using Quartic = LeastSquares<D, 4>;

extern template class LeastSquares<1, 2>;
extern template class LeastSquares<2, 2>;
extern template class LeastSquares<3, 2>;
extern template class LeastSquares<1, 3>;
extern template class LeastSquares<2, 3>;
extern template class LeastSquares<3, 3>;
extern template class LeastSquares<1, 4>;
extern template class LeastSquares<2, 4>;
extern template class LeastSquares<3, 4>;

}  // namespace mote
