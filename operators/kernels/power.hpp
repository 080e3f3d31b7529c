#pragma once

namespace mote {

/// x to a small whole power, by multiplication.
template <int N>
constexpr double power(double x) {
  double product = 1;
  for (int k = 0; k < N; ++k) product *= x;
  return product;
}

}  // namespace mote
