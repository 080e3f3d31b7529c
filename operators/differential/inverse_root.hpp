#pragma once

#include <array>
#include <limits>

#include "mote/operators/differential/fused.hpp"

namespace mote {

/// 1/x, and 0 where x = 0.
[[gnu::always_inline]] inline Lanes inverse_or_zero(const Lanes& x) {
  Lanes inverse = 1 / x;
  where(x == 0, inverse) = 0;
  return inverse;
}

/// Numbers in single precision, whose division and root are as exact as those in double precision
/// and so the same bits on every machine, but take a third of the time.
template <std::size_t Count>
using Singles = std::experimental::simd<float, std::experimental::simd_abi::deduce_t<float, Count>>;

/// 1/sqrt(x) and its powers, to a few units of rounding, from an estimate y = g/sqrt(x) (1 + d) in
/// single precision, |d| < 2^-22. With its deviation h = 1 - x (y/g)^2 = -2 d - d^2,
///   x^(-n/2) = (y/g)^n (1 - h)^(-n/2) = (y/g)^n (1 + n/2 h + n (n + 2)/8 h^2 + O(h^3)),
/// where the rest is below 2^-61, and where y^2 and g^2 are exact in double precision, so that
///   e = g^2 h = g^2 - x y^2
/// is too but for its own rounding. g is chosen for the cube: the coefficient of e^2,
/// 15/8 g^-7, is 1 to within 2^-14, which saves a multiplication.
/// Where x is no normal number in single precision, division and root take over: the powers are 0
/// where x = 0, and infinite where 1/x is.
class InverseRoot {
 public:
  static constexpr double g = 35847.0 / 32768;

  [[gnu::always_inline]] InverseRoot(const Lanes& x, const Lanes& y, bool is_single)
      : x_(x), y_(y), y2_(y * y), e_(fused(-x, y2_, g * g)), is_single_(is_single) {}

  /// 1/sqrt(x)
  [[gnu::always_inline]] Lanes value() const {
    const Lanes slope = fused(e_, 3.0 / 8 / (g2 * g3), 1.0 / 2 / g3);
    return checked(y_ * fused(e_, slope, 1 / g),
                   [](const Lanes& inverse) { return sqrt(inverse); });
  }
  /// 1/x
  [[gnu::always_inline]] Lanes square() const {
    const Lanes slope = fused(e_, 1 / (g3 * g3), 1 / (g2 * g2));
    return checked(y2_ * fused(e_, slope, 1 / g2), [](const Lanes& inverse) { return inverse; });
  }
  /// 1/sqrt(x)^3
  [[gnu::always_inline]] Lanes cube() const {
    const Lanes slope = e_ + 3.0 / 2 / (g2 * g3);
    return checked(y2_ * y_ * fused(e_, slope, 1 / g3),
                   [](const Lanes& inverse) { return inverse * sqrt(inverse); });
  }

 private:
  static constexpr double g2 = g * g, g3 = g * g2;

  /// The result, and a power of 1/x where x is beyond single precision.
  template <class Power>
  [[gnu::always_inline]] Lanes checked(Lanes result, Power power) const {
    if (!is_single_) [[unlikely]] {
      using std::experimental::static_simd_cast;
      const auto single = static_simd_cast<Lanes>(static_simd_cast<Singles<lane_count>>(x_));
      const auto is_normal = single >= std::numeric_limits<float>::min() &&
                             single <= std::numeric_limits<float>::max();
      where(!is_normal, result) = power(inverse_or_zero(x_));
    }
    return result;
  }

  Lanes x_, y_, y2_, e_;
  bool is_single_;
};

/// The estimates for two packs of numbers, as sixteen single ones take no longer than eight.
class RootEstimates {
 public:
  RootEstimates() = default;
  [[gnu::always_inline]] explicit RootEstimates(const std::array<Lanes, 2>& x) : x_(x) {
    const auto single = std::experimental::static_simd_cast<Singles<2 * lane_count>>(
        std::experimental::concat(x[0], x[1]));
    are_single_ = all_of(isnormal(single));
    estimate_ = static_cast<float>(InverseRoot::g) / sqrt(single);
  }

  [[gnu::always_inline]] InverseRoot refined(std::size_t pack) const {
    const auto packs = std::experimental::split<Singles<lane_count>>(estimate_);
    return {x_[pack], std::experimental::static_simd_cast<Lanes>(packs[pack]), are_single_};
  }

 private:
  std::array<Lanes, 2> x_;
  Singles<2 * lane_count> estimate_;
  bool are_single_;
};

}  // namespace mote
