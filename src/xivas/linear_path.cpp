#include "mote/xivas/linear_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote {

template <int D>
LinearPath<D>::LinearPath(const Mat<D>& gradient, const Vec<D>& velocity, double time,
                          double length)
    : duration_(time) {
  const double rate = std::max(gradient.norm(), velocity.norm() / length);
  if (rate * time > 1) duration_ = 1 / rate;
  const Mat<D> scaled = gradient * duration_;
  const double enough = velocity.norm() * duration_ * std::numeric_limits<double>::epsilon() / 8;
  Vec<D> term = velocity * duration_;
  while (terms_ < most_terms && term.norm() > enough) {
    term_[static_cast<std::size_t>(terms_++)] = term;
    term = scaled * term / (terms_ + 1);
  }
}

template <int D>
Vec<D> LinearPath<D>::displacement(double part) const {
  Vec<D> sum = Vec<D>::Zero();
  for (int k = terms_; k-- > 0;) sum = (sum + term_[static_cast<std::size_t>(k)]) * part;
  return sum;
}

template <int D>
Vec<D> LinearPath<D>::integral(double part) const {
  Vec<D> sum = Vec<D>::Zero();
  for (int k = terms_; k-- > 0;) sum = (sum + term_[static_cast<std::size_t>(k)] / (k + 2)) * part;
  return sum * (part * duration_);
}

template <int D>
typename LinearPath<D>::Polynomial LinearPath<D>::along(const Vec<D>& normal, double start) const {
  Polynomial of{start};
  for (std::size_t k = 0; k < static_cast<std::size_t>(terms_); ++k)
    of[k + 1] = normal.dot(term_[k]);
  return of;
}

namespace {

struct ValueAndSlope {
  double value = 0, slope = 0;
};

ValueAndSlope evaluated(std::span<const double> polynomial, double at) {
  ValueAndSlope of;
  for (std::size_t k = polynomial.size(); k-- > 0;) {
    of.slope = of.slope * at + of.value;
    of.value = of.value * at + polynomial[k];
  }
  return of;
}

/// The largest t with slope t + bend t^2 / 2 <= gap.
double safe_step(double slope, double bend, double gap) {
  const double root = std::sqrt(slope * slope + 2 * bend * gap);
  if (slope > 0) return 2 * gap / (slope + root);
  return bend > 0 ? (root - slope) / bend : std::numeric_limits<double>::infinity();
}

}  // namespace

double first_crossing(std::span<const double> polynomial, double limit, double end) {
  double highest = polynomial[0], bend = 0;
  for (std::size_t k = 1; k < polynomial.size(); ++k) {
    highest += std::max(0.0, polynomial[k]);
    bend += static_cast<double>(k * (k - 1)) * std::abs(polynomial[k]);
  }
  if (highest < limit / 2) return std::numeric_limits<double>::infinity();
  constexpr double shortest = std::numeric_limits<double>::epsilon();
  double at = 0;
  while (at < end) {
    const auto [value, slope] = evaluated(polynomial, at);
    if (value >= limit / 2) break;
    at += std::max(shortest, safe_step(slope, bend, limit - value));
  }
  return at;
}

template class LinearPath<2>;
template class LinearPath<3>;

}  // namespace mote
