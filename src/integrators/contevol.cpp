#include "mote/integrators/contevol.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>

namespace mote {
namespace {

using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Eigen::Index most_places = 300;

VectorXd copy_of(std::span<const double> values) {
  return Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::span<const double> span_of(const VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// integral of s^k P_i(s) over [0, 1] = sqrt(2i + 1) k!^2 / ((k - i)! (k + i + 1)!), with the
/// orthonormal Legendre polynomials P_i of this interval; k >= i.
double legendre_moment(int i, int k) {
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  return std::sqrt(2.0 * i + 1) * factorial(k) * factorial(k) /
         (factorial(k - i) * factorial(k + i + 1));
}

/// Turns blocks of rows for the powers s^k into blocks for P_i: then squares of rows add up to the
/// integral of the square.
template <class Rows>
void make_orthonormal(Rows& rows, Eigen::Index block, int degree) {
  for (int i = 0; i <= degree; ++i) {
    rows.middleRows(i * block, block) *= legendre_moment(i, i);
    for (int k = i + 1; k <= degree; ++k)
      rows.middleRows(i * block, block) +=
          legendre_moment(i, k) * rows.middleRows(k * block, block);
  }
}

/// The value at s = 1.
template <class Rows>
Rows sum_of_blocks(const Rows& rows, Eigen::Index block) {
  Rows sum = rows.topRows(block);
  for (Eigen::Index row = block; row < rows.rows(); row += block)
    sum += rows.middleRows(row, block);
  return sum;
}

/// x that minimises |matrix x + offset|.
VectorXd least_squares(const MatrixXd& matrix, const VectorXd& offset) {
  return -matrix.householderQr().solve(offset);
}

}  // namespace

std::string ContEvol::missing_in(System& system) const {
  if (system.force_series() == nullptr)
    return "forces as power series, which point masses under their own gravity have";
  if (system.drifted().front().value.size() > most_places)
    return "few bodies, 300 coordinates at most, for its equations are dense";
  return {};
}

void ContEvol::advance_one_step(System& system, double /*time*/, double step) {
  take_known_part(system, step);
  ForceSeries& series = *system.force_series();
  const VectorXd unknowns = best_unknowns(residual(series, step));
  const VectorXd scale = series.weights().cwiseSqrt();
  const Eigen::Index places = scale.size();
  for (int power = derivatives_ + 1; power <= degree(); ++power) {
    const Eigen::Index from = (power - derivatives_ - 1) * places;
    path_[power] = unknowns.segment(from, places).cwiseQuotient(scale);
  }
  move(system, step);
}

/// The Taylor series of the path up to the derivatives that are known at the start.
void ContEvol::take_known_part(System& system, double step) {
  step_ = step;
  path_.resize(degree() + 1);
  path_[0] = copy_of(system.drifted().front().value);
  path_[1] = step * copy_of(system.kicked().front().value);
  if (derivatives_ == 1) return;
  VectorXd force;
  system.force_series()->expand({path_.data(), 1}, {&force, 1}, {});
  path_[2] = step * step / 2 * force;
}

/// With s = t/h, x = p + d, p the known part, d = sum of unknowns[q] s^q from q = n + 1 on, and the
/// series f(p) = sum f_k s^k, f'(p) = sum J_k s^k, the residual of h^2 (x'' - f) at s^k is
///   (k + 2)(k + 1) x_(k+2) - h^2 (f_k + sum of J_(k-q) d_q),   k = 0 ... 2n + 1.
/// Equations and unknowns are scaled by the roots of the weights.
ContEvol::Residual ContEvol::residual(ForceSeries& series, double step) const {
  const int known = derivatives_ + 1, unknown = derivatives_ + 1;
  std::vector<VectorXd> force(degree() + 1);
  std::vector<MatrixXd> derivative(known);
  series.expand({path_.data(), static_cast<std::size_t>(known)}, force, derivative);
  const VectorXd scale = series.weights().cwiseSqrt();
  const Eigen::Index places = scale.size();
  Residual r{MatrixXd::Zero(places * (degree() + 1), places * unknown),
             VectorXd(places * (degree() + 1))};
  for (int k = 0; k <= degree(); ++k) {
    VectorXd error = -step * step * force[k];
    if (k + 2 < known) error += (k + 2) * (k + 1) * path_[k + 2];
    r.offset.segment(k * places, places) = scale.cwiseProduct(error);
  }
  for (MatrixXd& jacobian : derivative)
    jacobian = step * step * scale.asDiagonal() * jacobian * scale.cwiseInverse().asDiagonal();
  for (int u = 0; u < unknown; ++u) {
    const int q = known + u;
    r.matrix.block((q - 2) * places, u * places, places, places).diagonal().array() += q * (q - 1);
    for (int j = 0; q + j <= degree(); ++j)
      r.matrix.block((q + j) * places, u * places, places, places) -= derivative[j];
  }
  return r;
}

/// Where the equation must hold at s = 1, its residual there gives the highest unknowns in terms of
/// the others.
VectorXd ContEvol::best_unknowns(Residual r) const {
  const Eigen::Index places = r.offset.size() / (degree() + 1);
  const Eigen::Index others = r.matrix.cols() - places;
  const MatrixXd at_end = sum_of_blocks(r.matrix, places);
  const VectorXd offset_at_end = sum_of_blocks(r.offset, places);
  make_orthonormal(r.matrix, places, degree());
  make_orthonormal(r.offset, places, degree());
  if (end_ == End::free) return least_squares(r.matrix, r.offset);

  const Eigen::PartialPivLU<MatrixXd> highest(at_end.rightCols(places));
  const MatrixXd slope = -highest.solve(at_end.leftCols(others));
  const VectorXd start = -highest.solve(offset_at_end);
  const auto columns = r.matrix.rightCols(places);
  VectorXd unknowns(r.matrix.cols());
  unknowns.head(others) =
      least_squares(r.matrix.leftCols(others) + columns * slope, r.offset + columns * start);
  unknowns.tail(places) = slope * unknowns.head(others) + start;
  return unknowns;
}

void ContEvol::move(System& system, double step) {
  VectorXd velocity = path_[degree()], acceleration = degree() * path_[degree()];
  for (int k = degree() - 1; k >= 1; --k) velocity += path_[k];
  for (int k = degree() - 1; k >= 2; --k) acceleration += k * path_[k];
  velocity /= step;
  acceleration /= step * step;
  const Evolving drifts{system.drifted().front().value, span_of(velocity)};
  const Evolving kicks{system.kicked().front().value, span_of(acceleration)};
  drift(system, {&drifts, 1}, step);
  kick(system, {&kicks, 1}, step);
}

void ContEvol::go_along_path(System& system, double part) {
  VectorXd place = path_[degree()], velocity = degree() * path_[degree()];
  for (int k = degree() - 1; k >= 0; --k) place = place * part + path_[k];
  for (int k = degree() - 1; k >= 1; --k) velocity = velocity * part + k * path_[k];
  velocity /= step_;
  std::ranges::copy(span_of(place), system.drifted().front().value.begin());
  std::ranges::copy(span_of(velocity), system.kicked().front().value.begin());
}

}  // namespace mote
