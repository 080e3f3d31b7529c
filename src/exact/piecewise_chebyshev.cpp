#include "mote/exact/piecewise_chebyshev.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace mote {

PiecewiseChebyshev::PiecewiseChebyshev(std::function<double(double)> function, double lower,
                                       double upper)
    : function_(std::move(function)), width_(upper - lower) {
  if (!(lower < upper)) throw std::invalid_argument("the interval has no length");
  constexpr int samples = 1000;
  for (int k = 0; k <= samples; ++k)
    scale_ = std::fmax(scale_, std::abs(function_(lower + width_ * k / samples)));
  add(stretch(lower, upper), true);
}

void PiecewiseChebyshev::cover(double lower, double upper) {
  if (upper - this->upper() + this->lower() - lower > 4000 * width_)
    throw std::domain_error("the start is needed farther away than 4000 lengths of the domain");
  while (this->upper() < upper) add(stretch(this->upper(), this->upper() + width_), true);
  while (this->lower() > lower) add(stretch(this->lower() - width_, this->lower()), false);
}

std::size_t PiecewiseChebyshev::piece_at(double place) const {
  const auto above = std::ranges::upper_bound(pieces_, place, {}, &ChebyshevPiece::lower);
  return above == pieces_.begin() ? 0 : static_cast<std::size_t>(above - pieces_.begin()) - 1;
}

/// Appends pieces whose integrals start at 0, or puts them in front.
void PiecewiseChebyshev::add(Pieces pieces, bool at_the_end) {
  long double sum = 0;
  for (ChebyshevPiece& piece : pieces) {
    piece.before = sum;
    sum = piece.integral(piece.upper);
    largest_ = std::max(largest_, piece.largest);
  }
  long double start = 0;
  if (!pieces_.empty())
    start =
        at_the_end ? pieces_.back().integral(pieces_.back().upper) : pieces_.front().before - sum;
  for (ChebyshevPiece& piece : pieces) piece.before += start;
  pieces_.insert(at_the_end ? pieces_.end() : pieces_.begin(), pieces.begin(), pieces.end());
}

/// The pieces of one stretch, with all breaks between pieces.
PiecewiseChebyshev::Pieces PiecewiseChebyshev::stretch(double lower, double upper) const {
  // Wide enough that a jump of the second derivative still shows.
  const double narrow = std::ldexp(width_, -17);
  const auto gaps = unresolved(fitted(lower, upper, narrow));
  std::vector<double> corners{lower};
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const double from = k == 0 ? lower : gaps[k - 1].second;
    const double to = k + 1 == gaps.size() ? upper : gaps[k + 1].first;
    corners.push_back(located(gaps[k], from, to));
  }
  corners.push_back(upper);
  Pieces pieces;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    if (!(corners[k - 1] < corners[k])) continue;
    Pieces between = fitted(corners[k - 1], corners[k], 1e-13 * width_);
    std::ranges::move(between, std::back_inserter(pieces));
  }
  return pieces;
}

/// Halves until the pieces are resolved or narrow.
PiecewiseChebyshev::Pieces PiecewiseChebyshev::fitted(double lower, double upper,
                                                      double narrowest) const {
  constexpr int samples = 1000, enough_checks = 5;
  constexpr std::size_t too_many = 20'000;
  Pieces pieces;
  std::vector<Interval> open{{lower, upper}};  // the leftmost is the last
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const int checks =
        std::max(enough_checks, static_cast<int>(std::ceil(samples * (to - from) / width_)));
    ChebyshevPiece piece(function_, from, to, scale_, checks);
    const double middle = 0.5 * (from + to);
    if (piece.resolved || to - from <= narrowest || middle <= from || middle >= to) {
      pieces.push_back(piece);
    } else {
      open.emplace_back(middle, to);
      open.emplace_back(from, middle);
    }
    if (pieces.size() > too_many)
      throw std::invalid_argument("the start velocity is not piecewise smooth");
  }
  return pieces;
}

/// The intervals of unresolved pieces; those that touch are one.
std::vector<PiecewiseChebyshev::Interval> PiecewiseChebyshev::unresolved(const Pieces& pieces) {
  std::vector<Interval> intervals;
  for (const ChebyshevPiece& piece : pieces) {
    if (piece.resolved) continue;
    if (!intervals.empty() && intervals.back().second == piece.lower)
      intervals.back().second = piece.upper;
    else
      intervals.emplace_back(piece.lower, piece.upper);
  }
  return intervals;
}

/// Where in the gap the function leaves its polynomial from the left for the one from the right.
/// The function is smooth on [from, gap] and on [gap, to].
double PiecewiseChebyshev::located(const Interval& gap, double from, double to) const {
  auto [left, right] = gap;
  if (!(from < left)) return left;
  if (!(right < to)) return right;
  const double narrow = std::ldexp(width_, -17);
  const ChebyshevPiece before = fitted(from, left, narrow).back();
  const ChebyshevPiece after = fitted(right, to, narrow).front();
  for (;;) {
    const double middle = 0.5 * (left + right);
    if (middle <= left || middle >= right) return right;
    const double value = function_(middle);
    const bool is_left = std::abs(value - before(middle)) <= std::abs(value - after(middle));
    (is_left ? left : right) = middle;
  }
}

}  // namespace mote
