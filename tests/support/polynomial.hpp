#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "support/clouds.hpp"
#include "support/derivatives.hpp"

namespace mote::test {

/// A polynomial in D coordinates, as a list of monomials with factors.
template <int D>
class Polynomial {
 public:
  /// All monomials up to this degree, with random factors.
  Polynomial(int degree, std::uint64_t seed) {
    Draws draws(seed);
    std::array<int, D> powers{};
    add_monomials(powers, 0, degree, draws);
  }

  Polynomial derivative(int d) const {
    Polynomial result;
    for (Term term : terms_) {
      if (term.powers[d] == 0) continue;
      term.factor *= term.powers[d]--;
      result.terms_.push_back(term);
    }
    return result;
  }

  double operator()(const Vec<D>& x) const {
    double sum = 0;
    for (const Term& term : terms_) {
      double product = term.factor;
      for (int d = 0; d < D; ++d) product *= std::pow(x[d], term.powers[d]);
      sum += product;
    }
    return sum;
  }

 private:
  struct Term {
    std::array<int, D> powers;
    double factor;
  };

  Polynomial() = default;

  void add_monomials(std::array<int, D>& powers, int d, int left, Draws& draws) {
    if (d == D) {
      terms_.push_back({powers, draws.uniform(0.5, 1.5) * (draws.below(2) == 0 ? 1 : -1)});
      return;
    }
    for (powers[d] = 0; powers[d] <= left; ++powers[d])
      add_monomials(powers, d + 1, left - powers[d], draws);
    powers[d] = 0;
  }

  std::vector<Term> terms_;
};

/// A scalar and a vector field of polynomials of one degree.
template <int D>
class PolynomialFields {
 public:
  explicit PolynomialFields(int degree) : scalar_(degree, 11) {
    for (int d = 0; d < D; ++d) vector_.emplace_back(degree, 12 + d);
  }

  std::vector<double> scalar(const Points<D>& points) const {
    std::vector<double> values;
    for (Index i = 0; i < points.size(); ++i) values.push_back(scalar_(points.at(i)));
    return values;
  }
  std::vector<double> vector(const Points<D>& points) const {
    std::vector<double> values;
    for (Index i = 0; i < points.size(); ++i)
      for (const auto& component : vector_) values.push_back(component(points.at(i)));
    return values;
  }

  Derivatives derivatives(const Points<D>& points) const {
    Derivatives result;
    for (Index i = 0; i < points.receivers; ++i) {
      const Vec<D> x = points.at(i);
      add_scalar_derivatives(x, result);
      result.divergence.push_back(0);
      for (int d = 0; d < D; ++d) result.divergence.back() += slope(d, d, x);
      if constexpr (D == 2) result.curl.push_back(slope(1, 0, x) - slope(0, 1, x));
      if constexpr (D == 3)
        for (const auto [c, d] : {std::array{1, 2}, {2, 0}, {0, 1}})
          result.curl.push_back(slope(d, c, x) - slope(c, d, x));
    }
    return result;
  }

 private:
  void add_scalar_derivatives(const Vec<D>& x, Derivatives& result) const {
    result.laplacian.push_back(0);
    for (int c = 0; c < D; ++c) {
      const Polynomial<D> first = scalar_.derivative(c);
      result.gradient.push_back(first(x));
      for (int d = 0; d < D; ++d) result.hessian.push_back(first.derivative(d)(x));
      result.laplacian.back() += first.derivative(c)(x);
    }
  }

  /// Component c of the vector field, derived by coordinate d.
  double slope(int c, int d, const Vec<D>& x) const { return vector_[c].derivative(d)(x); }

  Polynomial<D> scalar_;
  std::vector<Polynomial<D>> vector_;
};

/// What an operator makes of polynomials of this degree.
template <int D>
Derivatives derivatives_of_polynomials(DifferentialOperator<D>& op, const Points<D>& points,
                                       int degree) {
  const PolynomialFields<D> fields(degree);
  return derivatives_of<D>(op, points, fields.scalar(points), fields.vector(points));
}

/// Whether all derivatives of polynomials of this degree are exact to within `tolerance`.
template <int D>
testing::AssertionResult is_exact(DifferentialOperator<D>& op, const Points<D>& points, int degree,
                                  double tolerance) {
  return all_agree<D>(derivatives_of_polynomials(op, points, degree),
                      PolynomialFields<D>(degree).derivatives(points), tolerance);
}

/// Whether no derivative of polynomials of this degree is exact to within `tolerance`.
template <int D>
testing::AssertionResult is_nowhere_exact(DifferentialOperator<D>& op, const Points<D>& points,
                                          int degree, double tolerance) {
  return none_agrees<D>(derivatives_of_polynomials(op, points, degree),
                        PolynomialFields<D>(degree).derivatives(points), tolerance);
}

}  // namespace mote::test
