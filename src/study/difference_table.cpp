#include "mote/study/difference_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>

#include "mote/xivas/divided_differences.hpp"
#include "mote/xivas/piecewise_differences.hpp"
#include "mote/xivas/spectral_exponentials.hpp"

namespace mote {
namespace {

using Long = long double;

template <class Real>
Real difference(const std::vector<Real>& nodes) {
  return exponential_difference(std::span<const Real>(nodes));
}

template <class Real>
Real pair_difference(Real y, Real x1, Real x2, Real x3) {
  const std::vector<std::complex<Real>> nodes{{0, -y}, {0, y}, x1, x2, x3};
  return exponential_difference(std::span<const std::complex<Real>>(nodes)).real();
}

/// A number that depends on h: by a scheme, and exactly.
using ByScheme = std::function<double(const std::string& scheme, double h)>;
struct Scalar {
  std::string table, quantity;
  ByScheme found;
  std::function<Long(Long h)> exact;
};

double second_difference(const std::string& scheme, double h) {
  const double x2 = 1 + h, x3 = 1 + 2 * h;
  if (scheme == "recursive") return recursive_difference(1, x2, x3);
  if (scheme == "collected") return collected_difference(1, x2, x3);
  if (scheme == "accurate") return difference<double>({1, x2, x3});
  return piecewise_difference(std::array{1.0, x2, x3}, scheme == "piecewise_one_term" ? 1 : 4);
}

double fourth_difference_of_pair(const std::string& scheme, double h) {
  if (scheme == "usual") return usual_pair_difference(h, 2 * h, 4 * h);
  if (scheme == "accurate") return pair_difference(2 * h, -h, -h, 3 * h);
  return piecewise_pair_difference(2 * h, std::array{-h, -h, 3 * h});
}

double fourth_difference(const std::string& scheme, double h) {
  if (scheme == "usual") return usual_r_difference(h, 2 * h, 3 * h);
  if (scheme == "accurate") return difference<double>({0, 0, h, 2 * h, 3 * h});
  return piecewise_pair_difference(0, std::array{h, 2 * h, 3 * h});
}

const std::vector<Scalar>& scalars() {
  static const std::vector<Scalar> all{
      {"second_difference", "exp[1; 1+h; 1+2h]", second_difference,
       [](Long h) {
         return difference<Long>({1, 1 + h, 1 + 2 * h});
       }},
      {"fourth_difference_of_pair", "Phi(2h)[-h; -h; 3h]", fourth_difference_of_pair,
       [](Long h) { return pair_difference(2 * h, -h, -h, 3 * h); }},
      {"fourth_difference", "r[h; 2h; 3h]", fourth_difference, [](Long h) {
         return difference<Long>({0, 0, h, 2 * h, 3 * h});
       }}};
  return all;
}

/// (189) with a = 0, b = c = 1, d = 4 and (195) with a = 0, b = c = d = 1.
template <class Real>
Eigen::Matrix<Real, 3, 3> matrix_of(const std::string& table, Real h) {
  Eigen::Matrix<Real, 3, 3> a;
  if (table == "matrices_of_pair")
    a << h, -2 * h, 1, 2 * h, h, 1, 0, 0, 4 * h;
  else
    a << h, 1, 1, 0, 2 * h, 1, 0, 0, 3 * h;
  return a;
}

MatrixExponentials<double, 3> exponentials_by(const std::string& scheme, const Eigen::Matrix3d& a) {
  if (scheme == "accurate") return matrix_exponentials<double, 3>(a, 1.0);
  return spectral_exponentials<3>(
      a, 1, scheme == "usual" ? SpectralScheme::usual : SpectralScheme::piecewise);
}

void add_scalar(const Scalar& scalar, const DifferenceTableFile& file, DifferenceTable& table) {
  std::vector<Long> values;
  for (std::size_t k = 0; k < table.h.size(); ++k)
    values.push_back(scalar.exact(std::pow(Long(10), -static_cast<Long>(k + 1))));
  table.exact.push_back({scalar.quantity, values});
  for (const std::string& scheme : file.schemes) {
    DifferenceColumn& column = table.columns.emplace_back(scheme, scalar.quantity);
    for (std::size_t k = 0; k < table.h.size(); ++k) {
      column.values.push_back(scalar.found(scheme, table.h[k]));
      column.errors.push_back(
          static_cast<double>(std::abs((column.values.back() - values[k]) / values[k])));
    }
  }
}

/// One of P, Q and R, in the Frobenius norm.
struct Part {
  const char* name;
  Eigen::Matrix3d MatrixExponentials<double, 3>::*found;
  Eigen::Matrix<Long, 3, 3> MatrixExponentials<Long, 3>::*exact;
};
constexpr Part parts[] = {
    {"R", &MatrixExponentials<double, 3>::r, &MatrixExponentials<Long, 3>::r},
    {"Q", &MatrixExponentials<double, 3>::q, &MatrixExponentials<Long, 3>::q},
    {"P", &MatrixExponentials<double, 3>::p, &MatrixExponentials<Long, 3>::p}};

void add_matrices(const DifferenceTableFile& file, DifferenceTable& table) {
  for (const Part& part : parts) {
    ExactColumn& norm = table.exact.emplace_back(part.name);
    std::vector<Eigen::Matrix<Long, 3, 3>> exact;
    for (std::size_t k = 0; k < table.h.size(); ++k) {
      const Long h = std::pow(Long(10), -static_cast<Long>(k + 1));
      exact.push_back(matrix_exponentials<Long, 3>(matrix_of(file.table, h), Long(1)).*part.exact);
      norm.values.push_back(exact.back().norm());
    }
    for (const std::string& scheme : file.schemes) {
      DifferenceColumn& column = table.columns.emplace_back(scheme, part.name);
      for (std::size_t k = 0; k < table.h.size(); ++k) {
        const Eigen::Matrix<Long, 3, 3> found =
            (exponentials_by(scheme, matrix_of(file.table, table.h[k])).*part.found).cast<Long>();
        column.values.push_back(static_cast<double>(found.norm()));
        column.errors.push_back(static_cast<double>((found - exact[k]).norm() / exact[k].norm()));
      }
    }
  }
}

}  // namespace

DifferenceTable evaluated(const DifferenceTableFile& file) {
  DifferenceTable table;
  for (std::int64_t k = 1; k <= file.decades; ++k)
    table.h.push_back(std::pow(10.0, -static_cast<double>(k)));
  const auto scalar = std::ranges::find(scalars(), file.table, &Scalar::table);
  if (scalar != scalars().end())
    add_scalar(*scalar, file, table);
  else
    add_matrices(file, table);
  return table;
}

}  // namespace mote
