#include "mote/app/reference_sum.hpp"

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <numbers>

#include "mote/operators/cores/all.hpp"

namespace mote {
namespace {

using Real = long double;

template <int D>
using Vector = Eigen::Matrix<Real, D, 1>;
template <int D>
using Matrix = Eigen::Matrix<Real, D, D>;

/// What depends on the square of the distance and on a core's size alone, q/r^D, its slope by r
/// over r, and the potential: in 2D ln r, in 3D 1/r far away.
struct DistanceLaw {
  Real (*influence)(Real square, Real size);
  Real (*slope)(Real square, Real size);
  Real (*potential)(Real square, Real size);
};

template <int D>
constexpr DistanceLaw point_law{
    [](Real square, Real) { return std::pow(std::sqrt(square), Real(-D)); },
    [](Real square, Real) { return -D * std::pow(std::sqrt(square), Real(-D - 2)); },
    [](Real square, Real) { return D == 2 ? std::log(square) / 2 : 1 / std::sqrt(square); }};

template <int D, class Core>
constexpr DistanceLaw core_law{
    [](Real square, Real size) {
      return Core::template influence<D>(static_cast<double>(square / (size * size))) /
             std::pow(size, Real(D));
    },
    [](Real square, Real size) {
      return Core::template influence_slope<D>(static_cast<double>(square / (size * size))) /
             std::pow(size, Real(D + 2));
    },
    [](Real square, Real size) {
      const Real value = Core::template potential<D>(static_cast<double>(square / (size * size)));
      return D == 2 ? value + std::log(size) : value / size;
    }};

template <int D>
DistanceLaw law_named(const std::string& core) {
  DistanceLaw law = point_law<D>;
  for_each_type(VortexCores{}, [&]<class Core>() {
    if (Core::name == core) law = core_law<D, Core>;
  });
  return law;
}

/// The matrix of the velocity's direction: in 3D that of the vector product with the circulation.
template <int D>
Matrix<D> turn(const double* circulation) {
  Matrix<D> a = Matrix<D>::Zero();
  const Real last = circulation[D == 2 ? 0 : 2];
  a(0, 1) = -last;
  a(1, 0) = last;
  if constexpr (D == 3) {
    a(0, 2) = circulation[1];
    a(1, 2) = -circulation[0];
    a(2, 0) = -circulation[1];
    a(2, 1) = circulation[0];
  }
  return a;
}

/// Gravity or the velocity of vortices.
template <int D>
class SpaceSum {
 public:
  SpaceSum(const SumTask& task, const SumPoints& points)
      : task_(task), points_(points), law_(law_named<D>(task.core)) {}

  std::vector<Real> operator()(std::size_t target) const {
    std::vector<Real> sums(task_.kernel == SumKernel::gravity ? 1 + D : D + task_.gradient * D * D);
    for (std::size_t j = 0; j < points_.source_count(); ++j) {
      const Vector<D> x = place(points_.places(), target) - place(points_.position, j);
      if (x.isZero(0) && task_.core == "point") continue;
      if (points_.at_sources && j == target && task_.kernel == SumKernel::gravity) continue;
      if (task_.kernel == SumKernel::gravity)
        add_mass(points_.strength[j], x, sums);
      else
        add_vortex(turn<D>(&points_.strength[D == 2 ? j : 3 * j]), x, sums);
    }
    return sums;
  }

 private:
  static Vector<D> place(const std::vector<double>& position, std::size_t i) {
    return Eigen::Map<const Eigen::Matrix<double, D, 1>>(&position[i * D]).template cast<Real>();
  }

  void add_mass(Real mass, const Vector<D>& x, std::vector<Real>& sums) const {
    const Real square = x.squaredNorm(), sign = D == 2 ? 1 : -1;
    sums[0] += sign * mass * law_.potential(square, task_.core_size);
    Eigen::Map<Vector<D>>(&sums[1]) += mass * law_.influence(square, task_.core_size) * x;
  }

  void add_vortex(const Matrix<D>& turn, const Vector<D>& x, std::vector<Real>& sums) const {
    constexpr Real sphere = (D == 2 ? 2 : 4) * std::numbers::pi_v<Real>;
    const Real square = x.squaredNorm();
    const Real influence = law_.influence(square, task_.core_size) / sphere;
    const Vector<D> direction = turn * x;
    Eigen::Map<Vector<D>>(&sums[0]) += influence * direction;
    if (!task_.gradient) return;
    const Real slope = law_.slope(square, task_.core_size) / sphere;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b)
        sums[D + D * a + b] += influence * turn(a, b) + slope * direction[a] * x[b];
  }

  const SumTask& task_;
  const SumPoints& points_;
  DistanceLaw law_;
};

std::vector<Real> cauchy_sum(const SumPoints& points, std::size_t target) {
  using Complex = std::complex<Real>;
  const auto place = [](const std::vector<double>& position, std::size_t i) {
    return Complex(position[2 * i], position[2 * i + 1]);
  };
  const bool real = points.strength.size() == points.source_count();
  const Complex s = place(points.places(), target);
  Complex sum = 0;
  for (std::size_t j = 0; j < points.source_count(); ++j)
    if (!points.at_sources || j != target)
      sum += (real ? Complex(points.strength[j]) : place(points.strength, j)) /
             (s - place(points.position, j));
  return {sum.real(), sum.imag()};
}

}  // namespace

std::function<std::vector<Real>(std::size_t target)> reference_sum(const SumTask& task,
                                                                   const SumPoints& points) {
  if (task.kernel == SumKernel::cauchy)
    return [&points](std::size_t target) { return cauchy_sum(points, target); };
  if (points.dimension == 2) return SpaceSum<2>(task, points);
  return SpaceSum<3>(task, points);
}

}  // namespace mote
