#include "mote/integrators/contevol.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace mote {
namespace {

using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Eigen::Index most_places = 300;

/// Powers of the force beyond the path's own. Without them, an orbit of eccentricity 63/64 in steps
/// of 1/256 is up to six times as far off.
constexpr int further_powers = 4;

VectorXd copy_of(std::span<const double> values) {
  return Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::span<const double> span_of(const VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// Turns blocks of rows for the powers s^k into blocks for the orthonormal Legendre polynomials P_i
/// of [0, 1]: then squares of rows add up to the integral of the square. The integral of s^k P_i is
///   sqrt(2i + 1) k!^2 / ((k - i)! (k + i + 1)!),   k >= i.
template <class Rows>
void make_orthonormal(Rows& rows, Eigen::Index block, int degree) {
  double ratio = 1;  // i!^2 / (2i + 1)!
  for (int i = 0; i <= degree; ++i) {
    if (i > 0) ratio *= i / (4.0 * i + 2);
    double moment = std::sqrt(2.0 * i + 1) * ratio;
    auto sum = rows.middleRows(i * block, block);
    sum *= moment;
    for (int k = i + 1; k <= degree; ++k) {
      moment *= k * k / ((k - i) * (k + i + 1.0));
      sum += moment * rows.middleRows(k * block, block);
    }
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

int ContEvol::last_power() const { return degree() + further_powers; }

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
///   (k + 2)(k + 1) x_(k+2) - h^2 (f_k + sum of J_(k-q) d_q),   k = 0 ... last_power().
/// Equations and unknowns are scaled by the roots of the weights.
ContEvol::Residual ContEvol::residual(ForceSeries& series, double step) const {
  const int known = derivatives_ + 1, unknown = derivatives_ + 1, powers = last_power() + 1;
  std::vector<VectorXd> force(powers);
  std::vector<MatrixXd> derivative(powers - known);
  series.expand({path_.data(), static_cast<std::size_t>(known)}, force, derivative);
  const VectorXd scale = series.weights().cwiseSqrt();
  const Eigen::Index places = scale.size();
  Residual r{MatrixXd::Zero(places * powers, places * unknown), VectorXd(places * powers)};
  for (int k = 0; k < powers; ++k) {
    VectorXd error = -step * step * force[k];
    if (k + 2 < known) error += (k + 2) * (k + 1) * path_[k + 2];
    r.offset.segment(k * places, places) = scale.cwiseProduct(error);
  }
  for (MatrixXd& jacobian : derivative)
    jacobian = step * step * scale.asDiagonal() * jacobian * scale.cwiseInverse().asDiagonal();
  for (int u = 0; u < unknown; ++u) {
    const int q = known + u;
    r.matrix.block((q - 2) * places, u * places, places, places).diagonal().array() += q * (q - 1);
    for (int j = 0; q + j < powers; ++j)
      r.matrix.block((q + j) * places, u * places, places, places) -= derivative[j];
  }
  return r;
}

/// Where the equation must hold at s = 1, its residual there gives the highest unknowns in terms of
/// the others.
VectorXd ContEvol::best_unknowns(Residual r) const {
  const Eigen::Index places = r.offset.size() / (last_power() + 1);
  const Eigen::Index others = r.matrix.cols() - places;
  const MatrixXd at_end = sum_of_blocks(r.matrix, places);
  const VectorXd offset_at_end = sum_of_blocks(r.offset, places);
  make_orthonormal(r.matrix, places, last_power());
  make_orthonormal(r.offset, places, last_power());
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
