#include "mote/walls/wall_remeshing.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

#include "mote/particles/failure.hpp"
#include "mote/particles/m4_prime.hpp"

namespace mote {
namespace {

constexpr int reach_beside_walls = 3;        ///< nodes each way
constexpr double radius_beside_walls = 2.9;  ///< spacings
constexpr double largest_weights = 3;        ///< sum of their sizes

struct Node {
  int i, j;
  Complex offset;  ///< from the particle, in spacings
};

/// Weights that conserve the moments up to `order`, with the least sum of squares over a nearness
/// that grows towards the particle; empty if there are none or if they are large.
std::vector<double> conserving_weights(const std::vector<Node>& nodes, int order) {
  const Eigen::Index moments = order == 2 ? 6 : order == 1 ? 3 : 1;
  const auto count = static_cast<Eigen::Index>(nodes.size());
  if (count < moments) return {};
  Eigen::MatrixXd scaled(moments, count);
  Eigen::VectorXd root(count), wanted = Eigen::VectorXd::Zero(moments);
  wanted[0] = 1;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double x = nodes[k].offset.real(), y = nodes[k].offset.imag();
    const double q = (x * x + y * y) / (radius_beside_walls * radius_beside_walls);
    root[k] = (1 - q) / std::sqrt(q + 1e-8);  // near 0 only the node itself counts
    const double powers[] = {1, x, y, x * x, x * y, y * y};
    for (Eigen::Index m = 0; m < moments; ++m) scaled(m, k) = root[k] * powers[m];
  }
  const Eigen::VectorXd weights =
      root.cwiseProduct(scaled.completeOrthogonalDecomposition().solve(wanted));
  const Eigen::VectorXd missed = scaled * weights.cwiseQuotient(root) - wanted;
  if (missed.cwiseAbs().maxCoeff() > 1e-10 || weights.cwiseAbs().sum() > largest_weights) return {};
  return {weights.begin(), weights.end()};
}

class Remeshing {
 public:
  Remeshing(const CutLattice& lattice, LatticeVorticity& result)
      : lattice_(lattice), result_(result) {}

  void add(Complex place, double circulation) {
    const Complex at = lattice_.in_spacings(place);
    const int i = static_cast<int>(std::floor(at.real())),
              j = static_cast<int>(std::floor(at.imag()));
    if (is_open(i, j))
      add_by_kernel(i, j, at, circulation);
    else
      add_beside_wall(place, circulation);
  }

 private:
  bool is_open(int i, int j) const {
    for (int dj = -1; dj <= 2; ++dj)
      for (int di = -1; di <= 2; ++di)
        if (!lattice_.is_whole(i + di, j + dj)) return false;
    return true;
  }

  void add_by_kernel(int i, int j, Complex at, double circulation) {
    const auto along_x = m4_prime_weights(at.real() - i), along_y = m4_prime_weights(at.imag() - j);
    for (int n = 0; n < 4; ++n)
      for (int m = 0; m < 4; ++m)
        result_.circulation[result_.box.place(i + m - 1, j + n - 1)] +=
            circulation * along_x[m] * along_y[n];
  }

  std::vector<Node> nodes_around(Complex at) const {
    std::vector<Node> nodes;
    const int i = static_cast<int>(std::lround(at.real()));
    const int j = static_cast<int>(std::lround(at.imag()));
    for (int dj = -reach_beside_walls; dj <= reach_beside_walls; ++dj)
      for (int di = -reach_beside_walls; di <= reach_beside_walls; ++di)
        if (const Complex offset = lattice_.in_spacings(lattice_.place(i + di, j + dj)) - at;
            std::abs(offset) < radius_beside_walls && lattice_.carries(i + di, j + dj))
          nodes.push_back({i + di, j + dj, offset});
    return nodes;
  }

  void add_beside_wall(Complex place, double circulation) {
    const std::vector<Node> nodes = nodes_around(lattice_.in_spacings(place));
    for (int order = 2; order >= 0; --order)
      if (const std::vector<double> weights = conserving_weights(nodes, order); !weights.empty()) {
        for (std::size_t k = 0; k < nodes.size(); ++k)
          result_.circulation[result_.box.place(nodes[k].i, nodes[k].j)] +=
              circulation * weights[k];
        return;
      }
    throw NumericalFailure(fmt::format("a vortex has got into a body, at ({:.6g}, {:.6g})",
                                       place.real(), place.imag()),
                           {}, "the step is too long");
  }

  const CutLattice& lattice_;
  LatticeVorticity& result_;
};

NodeBox box_around(const Vortices& particles, const CutLattice& lattice) {
  constexpr int margin = 6;
  NodeBox box = lattice.box();
  for (const Complex place : particles.place) {
    const Complex at = lattice.in_spacings(place);
    box = box.joined({static_cast<int>(std::floor(at.real())) - margin,
                      static_cast<int>(std::floor(at.imag())) - margin, 2 * margin, 2 * margin});
  }
  return box;
}

}  // namespace

LatticeVorticity remeshed(const Vortices& particles, const CutLattice& lattice) {
  LatticeVorticity result{box_around(particles, lattice), {}};
  result.circulation.assign(result.box.count(), 0);
  Remeshing remeshing(lattice, result);
  for (std::size_t k = 0; k < particles.place.size(); ++k)
    remeshing.add(particles.place[k], particles.circulation[k]);
  return result;
}

LostVorticity drop_weak(const CutLattice& lattice, double least, LatticeVorticity& vorticity) {
  LostVorticity lost;
  for (std::size_t k = 0; k < vorticity.circulation.size(); ++k) {
    double& circulation = vorticity.circulation[k];
    if (circulation == 0 || std::abs(circulation) > least) continue;
    lost.circulation += circulation;
    lost.impulse += impulse_of(circulation, lattice.place(vorticity.box.i(k), vorticity.box.j(k)));
    circulation = 0;
  }
  return lost;
}

LatticeParticles particles_of(const LatticeVorticity& vorticity, const CutLattice& lattice) {
  LatticeParticles result;
  for (std::size_t k = 0; k < vorticity.circulation.size(); ++k)
    if (vorticity.circulation[k] != 0) {
      result.place.push_back(lattice.place(vorticity.box.i(k), vorticity.box.j(k)));
      result.circulation.push_back(vorticity.circulation[k]);
      result.area.push_back(lattice.area(vorticity.box.i(k), vorticity.box.j(k)));
    }
  return result;
}

}  // namespace mote
