#pragma once

#include <cstddef>
#include <vector>

#include "mote/sums/harmonic_layout.hpp"

namespace mote {

/// One of the four parts of the matrix that exchanges the axes x and z within a degree. Symmetry
/// about the plane y = 0 keeps cosines and sines apart, symmetries about the planes x = 0 and z = 0
/// even and odd orders. Inputs and outputs are every second coefficient from the first on.
struct ExchangeBlock {
  int inputs, outputs;
  int first_input, first_output;  ///< within the coefficients of the degree
};

/// Number 0 and 1 are even and odd orders of cosines, 2 and 3 even and odd orders of sines.
constexpr ExchangeBlock exchange_block(int degree, int number) {
  const bool sines = number >= 2;
  const int parity = number % 2, into = (parity + degree + (sines ? 1 : 0)) % 2;
  const auto count = [&](int odd) { return odd ? (degree + 1) / 2 : degree / 2 + (sines ? 0 : 1); };
  const auto first = [&](int odd) { return sines ? degree + (odd ? 1 : 2) : odd; };
  return {count(parity), count(into), first(parity), first(into)};
}

/// Constants of solid harmonics up to the highest degree.
class HarmonicTables {
 public:
  HarmonicTables();

  /// The four blocks that exchange x and z, one after the other, each input by input.
  const double* exchange(int degree) const { return &exchange_[exchange_place_[degree]]; }
  /// Multipole to local along z, order by order: what degree n gives to degree l, at
  /// (n - m) row_length(m) + l - m, is (-1)^(l+m) (n+l)!/sqrt((n-m)! (n+m)! (l-m)! (l+m)!).
  const double* outward_to_inward(int order) const { return &inward_[order_place_[order]]; }
  /// A change of the centre along z: what degree n gives to degree l >= n of a multipole, at the
  /// same places: sqrt(C(l-m, l-n) C(l+m, l-n)). Degree l gives as much to n of a local expansion.
  const double* change_of_centre(int order) const { return &centre_[order_place_[order]]; }
  static std::size_t row_length(int order) { return degrees_of(highest_degree, order); }

  /// With R_n = r^n P_n^m(cos theta) / sin^m(theta), normalised, the order m at both places:
  /// R_n = rise z R_(n-1) - fall r^2 R_(n-2), at n - m.
  const double* rise(int order) const { return &rise_[rise_place(order)]; }
  const double* fall(int order) const { return &fall_[rise_place(order)]; }
  /// The first of them, R_m, over that of the order below.
  double first(int order) const { return first_[static_cast<std::size_t>(order)]; }

  /// d/dx of a harmonic of degree n is `below` times that of degree n - 1 and order m - 1 plus
  /// `above` times that of order m + 1 (a sine has none of order 0); d/dz is `along` times that of
  /// order m.
  double below(int degree, int order) const { return below_[slope_place(degree, order)]; }
  double above(int degree, int order) const { return above_[slope_place(degree, order)]; }
  double along(int degree, int order) const { return along_[slope_place(degree, order)]; }

 private:
  static std::size_t rise_place(int order) {
    return static_cast<std::size_t>(order) * (highest_degree + 1);
  }
  void fill_exchange();
  void fill_translations();
  static std::size_t slope_place(int degree, int order) {
    return static_cast<std::size_t>(degree * (degree + 1) / 2 + order);
  }
  void fill_recurrences();
  void fill_slopes();

  std::vector<double> exchange_, inward_, centre_, rise_, fall_, first_, below_, above_, along_;
  std::size_t exchange_place_[highest_degree + 1], order_place_[highest_degree + 1];
};

/// Made at the first call.
const HarmonicTables& harmonic_tables();

}  // namespace mote
