#pragma once

#include <array>

#include "mote/operators/differential/lanes.hpp"
#include "mote/sums/harmonic_tables.hpp"

namespace mote {

/// Regular solid harmonics at eight places, order by order from 0: those of degree n and order m
/// are of_degree(n) times cosine() and sine().
class SolidHarmonics {
 public:
  SolidHarmonics(int degree, const std::array<Lanes, 3>& place)
      : degree_(degree),
        place_(place),
        squared_(place[0] * place[0] + place[1] * place[1] + place[2] * place[2]) {}

  /// To be called with 0, 1, 2 ... in turn.
  void prepare_order(int order) {
    order_ = order;
    if (order > 0) turn();
    const auto m = static_cast<std::size_t>(order);
    const double* rise = tables_.rise(order);
    const double* fall = tables_.fall(order);
    const auto degrees = degrees_of(degree_, order);
    values_[m] = 1;
    if (degrees > 1) values_[m + 1] = rise[1] * place_[2];
    for (std::size_t i = 2; i < degrees; ++i)
      values_[m + i] =
          rise[i] * place_[2] * values_[m + i - 1] - fall[i] * squared_ * values_[m + i - 2];
  }

  int order() const { return order_; }
  const Lanes& of_degree(int degree) const { return values_[static_cast<std::size_t>(degree)]; }
  const Lanes& cosine() const { return cosine_; }
  const Lanes& sine() const { return sine_; }

 private:
  /// The next power of x + iy, normalised.
  void turn() {
    const double first = tables_.first(order_);
    const Lanes x = first * place_[0], y = first * place_[1], last = cosine_;
    cosine_ = x * last - y * sine_;
    sine_ = y * last + x * sine_;
  }

  const HarmonicTables& tables_ = harmonic_tables();
  int degree_, order_ = 0;
  std::array<Lanes, 3> place_;
  Lanes squared_, cosine_ = 1, sine_ = 0;
  std::array<Lanes, highest_degree + 1> values_;
};

}  // namespace mote
