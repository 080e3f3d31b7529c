// The observed orders of the operators in the plane, on lattices and on jittered lattices of the
// spacings 1/32 to 1/128. The printed operators lose all orders on disorder (ERRATA on (30)).

#include <gtest/gtest.h>

#include "mote/operators/differential/all.hpp"
#include "mote/operators/kernels/all.hpp"
#include "support/wave_on_a_box.hpp"

namespace mote::test {
namespace {

/// Half a period has the mean squares of the whole.
constexpr Box lattice{.count = 32, .part = 0.5}, jittered{.count = 32, .jitter = 0.2, .part = 0.5};

template <class Operator>
OrderCase<2> order_on(const std::string& name, Operator op, Box box, Promise promise,
                      double altered_by = 0.01) {
  return order_case<2>(name + (box.jitter > 0 ? "_jittered" : "_lattice"), op, box, 2, promise,
                       altered_by);
}

/// A fit of degree p has a gradient of order p at least, p + 1 where odd moments vanish, and one
/// order less in its Laplacian; the moments of a jittered lattice almost do, which helps on coarse
/// ones.
std::vector<OrderCase<2>> least_squares() {
  return {
      order_on("least_squares_2", Quadratic<2>(), lattice, {{2, 2}, {0.1, 0.1}, {1e-3, 6.5e-4}}),
      order_on("least_squares_2", Quadratic<2>(), jittered, {{2, 1.3}, {0.1, 0.2}, {1.5e-3, 2e-3}}),
      order_on("least_squares_3", Cubic<2>(), lattice, {{4, 2}, {0.1, 0.1}, {1.2e-6, 1.3e-3}}),
      order_on("least_squares_3", Cubic<2>(), jittered, {{3.1, 2}, {0.15, 0.1}, {8e-6, 1.3e-3}}),
      order_on("least_squares_4", Quartic<2>(), lattice, {{4, 4}, {0.1, 0.1}, {3.5e-6, 2e-6}}),
      order_on("least_squares_4", Quartic<2>(), jittered, {{4, 3.5}, {0.1, 0.3}, {1e-5, 1e-5}})};
}

/// Exact for linear fields in the gradient and for parabolas in the Laplacian: of order 1 in the
/// end, and of the kernel's order 2 before.
std::vector<OrderCase<2>> corrected_sph() {
  const CorrectedSph<2, WendlandC2<2>> wendland;
  const auto spline = with_length<CorrectedSph<2, CubicSpline<2>>>(3);
  return {
      order_on("corrected_sph_wendland_c2", wendland, lattice,
               {{2, 2}, {0.1, 0.1}, {3e-3, 1.5e-3}}),
      order_on("corrected_sph_wendland_c2", wendland, jittered,
               {{1.8, 1.65}, {0.15, 0.15}, {4e-3, 2.7e-3}}),
      order_on("corrected_sph_cubic_spline", spline, lattice, {{2, 2}, {0.1, 0.1}, {2e-3, 1e-3}}),
      order_on("corrected_sph_cubic_spline", spline, jittered,
               {{1.55, 1.4}, {0.15, 0.15}, {4e-3, 2.7e-3}})};
}

/// The same promise, and on disorder it is nearer to its order 1 at these spacings.
std::vector<OrderCase<2>> corrected_mps() {
  return {
      order_on("corrected_mps", CorrectedMps<2>(), lattice, {{2, 2}, {0.1, 0.1}, {1.5e-3, 7e-4}}),
      order_on("corrected_mps", CorrectedMps<2>(), jittered,
               {{1.3, 1}, {0.15, 0.1}, {4.5e-3, 7e-3}})};
}

/// The form of SPH with the weight of MPS has the error of its normalisation, at any spacing.
std::vector<OrderCase<2>> printed() {
  return {order_on("sph_cubic_spline", with_length<Sph<2, CubicSpline<2>>>(3), jittered,
                   {{0, -1}, {0.15, 0.15}, {0.08, 3.5}}, 1),
          order_on("mps", Mps<2>(), lattice, {{2, 2}, {0.1, 0.1}, {1e-3, 5.5e-4}}),
          order_on("mps", Mps<2>(), jittered, {{0, -1}, {0.15, 0.15}, {0.16, 3.7}}, 1),
          order_on("mps_as_sph", MpsAsSph<2>(), lattice, {{0, 0}, {0.05, 0.05}, {0.8, 0.92}}, -1),
          order_on("finite_difference", FiniteDifference<2>(), lattice,
                   {{2, 2}, {0.1, 0.1}, {5e-4, 2.5e-4}})};
}

struct OrderInThePlane : testing::TestWithParam<OrderCase<2>> {};

TEST_P(OrderInThePlane, IsAsPromised) {
  EXPECT_TRUE(keeps_its_promise(*GetParam().make(), GetParam()));
}

TEST_P(OrderInThePlane, IsNotThatOfAnAlteredOperator) {
  EXPECT_FALSE(keeps_its_promise(*GetParam().make_altered(), GetParam()));
}

constexpr auto name_of = [](const auto& order) { return order.param.name; };
INSTANTIATE_TEST_SUITE_P(LeastSquares, OrderInThePlane, testing::ValuesIn(least_squares()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(CorrectedSph, OrderInThePlane, testing::ValuesIn(corrected_sph()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(CorrectedMps, OrderInThePlane, testing::ValuesIn(corrected_mps()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Printed, OrderInThePlane, testing::ValuesIn(printed()), name_of);

}  // namespace
}  // namespace mote::test
