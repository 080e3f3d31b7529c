#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "mote/exact/chebyshev_piece.hpp"

namespace mote {

/// A piecewise smooth function as polynomials, to the rounding of double precision, with its
/// integral. Pieces are halved until each is resolved. What stays unresolved on very narrow pieces
/// is a break, a kink or a jump: it is located to rounding, and pieces end there.
class PiecewiseChebyshev {
 public:
  /// Covers [lower, upper], the first stretch. Features narrower than 1/1000 of it may be missed.
  /// Throws std::invalid_argument where the function is no number or not piecewise smooth.
  PiecewiseChebyshev(std::function<double(double)> function, double lower, double upper);

  /// Covers these places too, in steps of the first stretch. Throws std::domain_error if that is
  /// more than 4000 of them.
  void cover(double lower, double upper);

  /// In order, without gaps.
  const std::vector<ChebyshevPiece>& pieces() const { return pieces_; }
  /// The piece at a place that is covered.
  std::size_t piece_at(double place) const;

  double lower() const { return pieces_.front().lower; }
  double upper() const { return pieces_.back().upper; }

  /// The largest magnitude of the function in what is covered, by samples.
  double largest() const { return largest_; }

 private:
  using Pieces = std::vector<ChebyshevPiece>;
  using Interval = std::pair<double, double>;

  Pieces stretch(double lower, double upper) const;
  Pieces fitted(double lower, double upper, double narrowest) const;
  static std::vector<Interval> unresolved(const Pieces& pieces);
  double located(const Interval& gap, double from, double to) const;
  void add(Pieces pieces, bool at_the_end);

  std::function<double(double)> function_;
  double width_, scale_ = 0, largest_ = 0;
  Pieces pieces_;
};

}  // namespace mote
