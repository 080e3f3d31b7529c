#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "mote/neighbours/kd_tree.hpp"
#include "mote/operators/differential/apply.hpp"
#include "support/altered_operator.hpp"
#include "support/random.hpp"

namespace mote::test {

/// Which points a wave is derived at: `count` cells of the unit length a direction, their points
/// moved by up to `jitter` spacings in each coordinate. Receivers are those of [0, part]^D; half a
/// period or a quarter has the mean squares of the whole.
struct Box {
  Index count;
  double jitter = 0;
  double part = 1;
};

/// The points of a box and, beyond it, those that an operator of this reach in spacings can see.
template <int D>
Points<D> points_of(const Box& box, double reach) {
  const auto receivers = static_cast<Index>(std::lround(box.count * box.part));
  const auto beyond = static_cast<Index>(std::ceil(reach + 2 * box.jitter));
  const Index side = receivers + 2 * beyond;
  const double spacing = 1.0 / box.count;
  Draws draws(5);
  std::vector<Vec<D>> inner, outer;
  for (Index i = 0; i < std::pow(side, D); ++i) {
    Vec<D> place;
    bool inside = true;
    Index rest = i;
    for (int d = 0; d < D; ++d, rest /= side) {
      const Index k = rest % side - beyond;
      inside = inside && k >= 0 && k < receivers;
      place[d] = (k + 0.5 + draws.uniform(-box.jitter, box.jitter)) * spacing;
    }
    (inside ? inner : outer).push_back(place);
  }
  Points<D> points;
  points.resize(static_cast<Index>(inner.size() + outer.size()), static_cast<Index>(inner.size()));
  inner.insert(inner.end(), outer.begin(), outer.end());
  for (std::size_t i = 0; i < inner.size(); ++i) Vec<D>::Map(&points.position[i * D]) = inner[i];
  points.length.assign(inner.size(), spacing);
  points.mass.assign(inner.size(), std::pow(spacing, D));
  points.density.assign(inner.size(), 1);
  return points;
}

/// sin(k x) cos(k y) sin(k z), k = 2 pi, or its first two factors, and its gradient.
template <int D>
struct Wave {
  static constexpr double k = 2 * std::numbers::pi;
  static constexpr double laplacian_factor = -D * k * k;

  static double value(const Vec<D>& x) {
    double product = 1;
    for (int d = 0; d < D; ++d) product *= factor(d, x[d]);
    return product;
  }
  static Vec<D> gradient(const Vec<D>& x) {
    Vec<D> result;
    for (int c = 0; c < D; ++c) {
      result[c] = k * (c == 1 ? -std::sin(k * x[c]) : std::cos(k * x[c]));
      for (int d = 0; d < D; ++d)
        if (d != c) result[c] *= factor(d, x[d]);
    }
    return result;
  }

 private:
  static double factor(int d, double x) { return d == 1 ? std::cos(k * x) : std::sin(k * x); }
};

struct Pair {
  double gradient, laplacian;
};

/// L2 errors of the wave's derivatives over all components, relative to those derivatives.
template <int D>
Pair errors_of(DifferentialOperator<D>& op, const Box& box) {
  const Points<D> points = points_of<D>(box, op.neighbour_rule().reach());
  NeighbourLists lists;
  KdTreeSearch<D>().find(points, op.neighbour_rule(), lists);
  op.prepare(points, lists);
  std::vector<double> wave, first(points.receivers * D), second(points.receivers);
  for (Index i = 0; i < points.size(); ++i) wave.push_back(Wave<D>::value(points.at(i)));
  gradient<D>(op, lists, wave, first);
  laplacian<D>(op, lists, wave, second);
  Pair error{0, 0}, size{0, 0};
  for (Index i = 0; i < points.receivers; ++i) {
    const Vec<D> slope = Wave<D>::gradient(points.at(i));
    const double curvature = Wave<D>::laplacian_factor * wave[i];
    error.gradient += (Vec<D>::Map(&first[i * D]) - slope).squaredNorm();
    error.laplacian += std::pow(second[i] - curvature, 2);
    size.gradient += slope.squaredNorm();
    size.laplacian += std::pow(curvature, 2);
  }
  return {std::sqrt(error.gradient / size.gradient), std::sqrt(error.laplacian / size.laplacian)};
}

/// Orders between a box and one with `doublings` times twice as many points a direction, and the
/// errors on the latter.
struct Observed {
  Pair order, last;
};
template <int D>
Observed observe(DifferentialOperator<D>& op, Box box, int doublings) {
  const Pair first = errors_of(op, box);
  box.count <<= doublings;
  const Pair last = errors_of(op, box);
  return {{std::log2(first.gradient / last.gradient) / doublings,
           std::log2(first.laplacian / last.laplacian) / doublings},
          last};
}

/// What an operator promises: orders to within `tolerance` from both sides, errors at most these.
struct Promise {
  Pair order, tolerance, ceiling;
};

inline testing::AssertionResult keeps(const Observed& found, const Promise& promise) {
  if (std::abs(found.order.gradient - promise.order.gradient) <= promise.tolerance.gradient &&
      std::abs(found.order.laplacian - promise.order.laplacian) <= promise.tolerance.laplacian &&
      found.last.gradient <= promise.ceiling.gradient &&
      found.last.laplacian <= promise.ceiling.laplacian)
    return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "orders " << found.order.gradient << " and " << found.order.laplacian << ", errors "
         << found.last.gradient << " and " << found.last.laplacian;
}

/// An operator with what it promises on a lattice and on points moved by a fifth of a spacing.
template <int D>
struct OrderCase {
  std::string name;
  Box box;
  int doublings;
  Promise promise;
  std::function<std::unique_ptr<DifferentialOperator<D>>()> make;
  std::function<std::unique_ptr<DifferentialOperator<D>>()> make_altered;  ///< what must be noticed

  friend void PrintTo(const OrderCase& order, std::ostream* out) { *out << order.name; }
};

/// `altered_by` is the part of the largest weight of every row by which the altered operator errs.
template <int D, class Operator>
OrderCase<D> order_case(const std::string& name, Operator op, Box box, int doublings,
                        Promise promise, double altered_by = 0.01) {
  return {
      name,
      box,
      doublings,
      promise,
      [=] { return std::make_unique<Operator>(op); },
      [=] { return std::make_unique<AlteredOperator<D, Operator>>(op, std::nullopt, altered_by); }};
}

template <int D>
testing::AssertionResult keeps_its_promise(DifferentialOperator<D>& op, const OrderCase<D>& order) {
  return keeps(observe(op, order.box, order.doublings), order.promise);
}

/// An operator with another smoothing length than its usual one.
template <class Operator>
Operator with_length(double smoothing_length) {
  Operator op;
  op.smoothing_length = smoothing_length;
  return op;
}

}  // namespace mote::test
