#pragma once

namespace mote {

/// x to a small whole power, by multiplication.
template <int N, class Real>
[[gnu::always_inline]] constexpr Real power(const Real& x) {
  Real product = x;
  for (int k = 1; k < N; ++k) product = product * x;
  return product;
}

}  // namespace mote
