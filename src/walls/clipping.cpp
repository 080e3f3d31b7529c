#include "mote/walls/clipping.hpp"

#include <algorithm>
#include <utility>

namespace mote {
namespace {

/// A half plane that is bounded by a line along an axis.
struct HalfPlane {
  bool along_x;  ///< whether the bound is one of x
  double bound;
  bool below;  ///< whether what is below the bound is kept

  double coordinate(Complex z) const { return along_x ? z.real() : z.imag(); }
  bool keeps(Complex z) const { return below ? coordinate(z) <= bound : coordinate(z) >= bound; }
  /// Where the line from a to b passes the bound, exactly on it.
  Complex crossing(Complex a, Complex b) const {
    const double t = (bound - coordinate(a)) / (coordinate(b) - coordinate(a));
    const Complex z = a + t * (b - a);
    return along_x ? Complex(bound, z.imag()) : Complex(z.real(), bound);
  }
};

/// One step of Sutherland and Hodgman's clipping. Sides that it adds run along the bound, forth and
/// back where a polygon is cut in several pieces, so that signed lengths and areas stay right.
std::vector<Complex> clipped(const std::vector<Complex>& corners, const HalfPlane& half) {
  std::vector<Complex> kept;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Complex a = corners[k], b = corners[(k + 1) % corners.size()];
    if (half.keeps(a)) kept.push_back(a);
    if (half.keeps(a) != half.keeps(b)) kept.push_back(half.crossing(a, b));
  }
  return kept;
}

}  // namespace

Cover cover_of(std::span<const Panel> polygon, Complex middle, double side) {
  const double right = middle.real() + side / 2, above = middle.imag() + side / 2;
  std::vector<Complex> corners;
  for (const Panel& panel : polygon) corners.push_back(panel.from);
  for (const HalfPlane& half :
       {HalfPlane{true, right, true}, HalfPlane{true, middle.real() - side / 2, false},
        HalfPlane{false, above, true}, HalfPlane{false, middle.imag() - side / 2, false}})
    corners = clipped(corners, half);
  Cover cover;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Complex a = corners[k] - middle, b = corners[(k + 1) % corners.size()] - middle;
    const double triangle = (std::conj(a) * b).imag() / 2;
    cover.area += triangle;
    cover.moment += triangle * (a + b) / 3.0;
    if (corners[k].real() == right && corners[(k + 1) % corners.size()].real() == right)
      cover.right += b.imag() - a.imag();
    if (corners[k].imag() == above && corners[(k + 1) % corners.size()].imag() == above)
      cover.above -= b.real() - a.real();
  }
  return cover;
}

Piece piece_inside(const Panel& panel, Complex middle, double side) {
  Piece piece;
  const auto cut = [&](double start, double step) {  // |start + t step| <= side/2
    if (step == 0) {
      if (std::abs(start) > side / 2) piece.to = piece.from;
      return;
    }
    const double enter = -start / step, half = side / 2 / std::abs(step);
    piece.from = std::max(piece.from, enter - half);
    piece.to = std::min(piece.to, enter + half);
  };
  const Complex start = panel.from - middle, step = panel.to - panel.from;
  cut(start.real(), step.real());
  cut(start.imag(), step.imag());
  return piece;
}

}  // namespace mote
