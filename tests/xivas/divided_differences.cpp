#include "mote/xivas/divided_differences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mote/xivas/piecewise_differences.hpp"
#include "xivas/precise.hpp"

namespace mote {
namespace {

using Complex = std::complex<double>;

double relative_error(double found, const precise::Real& exact) {
  return std::abs(static_cast<double>(precise::Real((precise::Real(found) - exact) / exact)));
}

/// Of differences with complex nodes: over the difference of their real parts.
double relative_error(Complex found, const std::vector<Complex>& nodes) {
  std::vector<precise::Complex> exact(nodes.begin(), nodes.end());
  std::vector<double> real_parts;
  for (const Complex& node : nodes) real_parts.push_back(node.real());
  return precise::size(precise::Complex(found) - precise::difference(exact)) /
         static_cast<double>(precise::difference(real_parts));
}

double in_double(const std::vector<double>& nodes) {
  return exponential_difference(std::span<const double>(nodes));
}

double in_long_double(const std::vector<double>& nodes) {
  const std::vector<long double> copy(nodes.begin(), nodes.end());
  return static_cast<double>(exponential_difference(std::span<const long double>(copy)));
}

Complex in_double(const std::vector<Complex>& nodes) {
  return exponential_difference(std::span<const Complex>(nodes));
}

Complex in_long_double(const std::vector<Complex>& nodes) {
  const std::vector<std::complex<long double>> copy(nodes.begin(), nodes.end());
  return Complex(exponential_difference(std::span<const std::complex<long double>>(copy)));
}

/// One to five nodes between -50 and 50: all over it, close together, some equal, some zero.
std::vector<double> random_nodes(std::mt19937_64& random, int kind) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> nodes(static_cast<std::size_t>(1 + kind % 5));
  const double spread = kind % 3 == 0 ? 50 : std::pow(10.0, 1.6 - 12 * std::abs(unit(random)));
  const double centre = (50 - spread) * unit(random);
  for (double& node : nodes) node = centre + spread * unit(random);
  if (kind % 7 == 1) nodes.back() = nodes.front();
  if (kind % 11 == 1) nodes.front() = 0;
  return nodes;
}

/// The same with imaginary parts, half of the time in conjugate pairs.
std::vector<Complex> random_complex_nodes(std::mt19937_64& random, int kind) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const double height = kind % 4 == 0 ? 50 : std::pow(10.0, 1.6 - 12 * std::abs(unit(random)));
  std::vector<Complex> nodes;
  for (const double x : random_nodes(random, kind)) nodes.emplace_back(x, height * unit(random));
  for (std::size_t i = 1; kind % 2 == 0 && i < nodes.size(); i += 2)
    nodes[i] = std::conj(nodes[i - 1]);
  return nodes;
}

struct Worst {
  double with_double = 0, with_long_double = 0;

  void take(double error, double error_of_long) {
    with_double = std::max(with_double, error);
    with_long_double = std::max(with_long_double, error_of_long);
  }
};

TEST(ExponentialDifference, OfRealNodesIsRight) {
  std::mt19937_64 random(1);
  Worst worst;
  for (int kind = 0; kind < 400; ++kind) {
    const auto nodes = random_nodes(random, kind);
    const auto exact = precise::difference(nodes);
    worst.take(relative_error(in_double(nodes), exact),
               relative_error(in_long_double(nodes), exact));
  }
  EXPECT_LT(worst.with_double, 1e-14);
  EXPECT_LT(worst.with_long_double, 2.6e-16);
}

TEST(ExponentialDifference, OfComplexNodesIsRight) {
  std::mt19937_64 random(2);
  Worst worst;
  for (int kind = 0; kind < 400; ++kind) {
    const auto nodes = random_complex_nodes(random, kind);
    worst.take(relative_error(in_double(nodes), nodes),
               relative_error(in_long_double(nodes), nodes));
  }
  EXPECT_LT(worst.with_double, 1e-14);
  EXPECT_LT(worst.with_long_double, 2.6e-16);
}

TEST(ExponentialDifference, OfEqualNodesIsADerivative) {
  EXPECT_NEAR(in_double(std::vector<double>{-3, -3, -3, -3, -3}) / (std::exp(-3) / 24), 1, 1e-15);
  EXPECT_DOUBLE_EQ(in_double(std::vector<double>{0, 0, 0}), 0.5);
}

TEST(ExponentialDifference, OfNodesFarBeyondTheRangeOfTheExponentialIsFinite) {
  EXPECT_NEAR(in_double(std::vector<double>{-900, 0}) * 900, 1, 1e-15);
  EXPECT_NEAR(in_double(std::vector<double>{-900, -1e5, 1}) * 901 * 100001 / std::exp(1), 1, 2e-15);
}

TEST(ExponentialDifference, RefusesNoNodesAndSix) {
  EXPECT_THROW(in_double(std::vector<double>{}), std::invalid_argument);
  EXPECT_THROW(in_double(std::vector<double>(6)), std::invalid_argument);
  EXPECT_THROW(in_double(std::vector<Complex>(6)), std::invalid_argument);
}

/// The worst relative error of the paper's scheme over random real nodes of this number.
double worst_of_piecewise(std::size_t count) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  double worst = 0;
  for (int n = 0; n < 500; ++n) {
    const double spread = std::pow(10.0, 0.5 - 3 * std::abs(unit(random)));
    std::vector<double> nodes(count);
    for (double& node : nodes) node = spread * unit(random);
    worst =
        std::max(worst, relative_error(piecewise_difference(nodes), precise::difference(nodes)));
  }
  return worst;
}

TEST(PiecewiseDifference, LosesAsManyDigitsAsItsOrderSays) {
  struct Bounds {
    std::size_t count;
    double lower, upper;
  };
  for (const Bounds of :
       {Bounds{2, 0, 1e-15}, {3, 5e-15, 1e-12}, {4, 5e-13, 1e-10}, {5, 2e-11, 5e-9}}) {
    const double worst = worst_of_piecewise(of.count);
    EXPECT_GT(worst, of.lower) << of.count;
    EXPECT_LT(worst, of.upper) << of.count;
  }
}

TEST(PiecewiseDifference, OfAPairIsRightOnBothSidesOfItsThresholds) {
  for (const double size : {1e-8, 1e-3, 0.9e-2, 0.03, 0.07, 0.4, 3.0}) {
    const double y = 0.7 * size;
    const std::vector<double> x{-0.4 * size, 0.3 * size, size};
    const double limits[] = {1e-15, 1e-13, 1e-11, 1e-9};
    std::vector<Complex> nodes{{0, -y}, {0, y}};
    for (std::size_t count = 0; count <= 3; ++count) {
      const double found = piecewise_pair_difference(y, std::span(x).first(count));
      EXPECT_LT(relative_error(Complex(found), nodes), limits[count]) << size << ' ' << count;
      if (count < 3) nodes.emplace_back(x[count]);
    }
  }
}

TEST(PiecewiseDifference, WithOneTermOfItsSeriesIsWorse) {
  const std::vector<double> nodes{1, 1 + 1e-5, 1 + 2e-5};
  const auto exact = precise::difference(nodes);
  EXPECT_LT(relative_error(piecewise_difference(nodes), exact), 1e-15);
  EXPECT_GT(relative_error(piecewise_difference(nodes, 1), exact), 1e-12);
  EXPECT_LT(relative_error(piecewise_difference(nodes, 1), exact), 1e-10);
}

// The columns "exact" of Tables 2, 3 and 5 (the last two in units of 1/100), cut off after 16
// digits.
struct TableRow {
  int decade;
  double table_2, table_3, table_5;
};
constexpr TableRow rows[] = {
    {1, 1.503335165136325, 4.252986132162584, 4.703252003748591},
    {2, 1.372811947550820, 4.175027977160363, 4.217015682095156},
    {3, 1.360500848315854, 4.167500277976287, 4.171670140675349},
    {4, 1.359276836249607, 4.166750002777976, 4.167166701390674},
    {5, 1.359154505717948, 4.166675000027777, 4.166716667013890},
    {8, 1.359140927820931, 4.166666675000000, 4.166666716666667},
    {12, 1.359140914230881, 4.166666666667500, 4.166666666671666},
    {15, 1.359140914229523, 4.166666666666667, 4.166666666666671},
};

TEST(ExponentialDifference, HasTheExactColumnsOfThePapersTables) {
  for (const TableRow& row : rows) {
    const long double h = std::pow(10.0L, -row.decade);
    const std::vector<long double> two{1, 1 + h, 1 + 2 * h}, five{0, 0, h, 2 * h, 3 * h};
    const std::vector<std::complex<long double>> three{{0, -2 * h}, {0, 2 * h}, -h, -h, 3 * h};
    const auto difference = [](const auto& nodes) {
      return exponential_difference(std::span(nodes.data(), nodes.size()));
    };
    const double last_digit = 2e-15;
    EXPECT_NEAR(difference(two), row.table_2, last_digit) << row.decade;
    EXPECT_NEAR(100 * difference(three).real(), row.table_3, last_digit) << row.decade;
    EXPECT_NEAR(100 * difference(five), row.table_5, last_digit) << row.decade;
  }
}

TEST(PiecewiseDifference, HasTheDigitsThatThePapersTablesPromise) {
  for (const TableRow& row : rows) {
    const double h = std::pow(10.0, -row.decade);
    const std::vector<double> two{1, 1 + h, 1 + 2 * h}, three{-h, -h, 3 * h}, five{h, 2 * h, 3 * h};
    EXPECT_NEAR(piecewise_difference(two), row.table_2, 3e-14) << row.decade;
    EXPECT_NEAR(piecewise_difference(two, 1), row.table_2, 4e-11) << row.decade;
    EXPECT_NEAR(100 * piecewise_pair_difference(2 * h, three), row.table_3, 2e-12) << row.decade;
    EXPECT_NEAR(100 * piecewise_pair_difference(0, five), row.table_5, 1e-11) << row.decade;
  }
}

TEST(NaiveDifferences, LoseAllDigits) {
  const double h = 1e-9, exact = std::exp(1.0) / 2;
  EXPECT_GT(std::abs(recursive_difference(1, 1 + h, 1 + 2 * h) / exact - 1), 0.5);
  EXPECT_GT(std::abs(collected_difference(1, 1 + h, 1 + 2 * h) / exact - 1), 0.5);
  EXPECT_GT(std::abs(usual_r_difference(1e-6, 2e-6, 3e-6) * 24 - 1), 0.5);
  EXPECT_GT(std::abs(usual_pair_difference(1e-6, 2e-6, 4e-6) * 24 - 1), 0.5);
}

}  // namespace
}  // namespace mote
