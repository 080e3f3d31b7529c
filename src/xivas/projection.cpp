#include "mote/xivas/projection.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "mote/particles/failure.hpp"

namespace mote {

template <int D>
Projection<D>::Projection(const SimplexMesh<D>& mesh, std::span<const double> positions,
                          std::span<const Index> cells, ProjectionKind kind)
    : mesh_(mesh), shares_(static_cast<std::size_t>(mesh.point_count())) {
  if (cells.empty()) throw InputError("there are no particles to project onto the mesh");
  for (std::size_t p = 0; p < cells.size(); ++p) {
    const MeshCell<D>& cell = mesh.cell(cells[p]);
    const Vec<D> place = Vec<D>::Map(&positions[p * D]);
    for (std::size_t v = 0; v <= D; ++v) {
      const double shape = -cell.faces[v].distance(place) / cell.faces[v].height;
      if (shape > 0)
        shares_[static_cast<std::size_t>(cell.vertices[v])].push_back(
            {static_cast<Index>(p), shape});
    }
  }
  if (kind == ProjectionKind::least_squares) weigh_for_fits(positions);
  weigh_for_means();
  find_empty();
}

/// Weights add up to 1; those of a fit do but for rounding.
template <int D>
void Projection<D>::weigh_for_means() {
  for (auto& shares : shares_) {
    double sum = 0;
    for (const Share& share : shares) sum += share.weight;
    for (Share& share : shares) share.weight /= sum;
  }
}

/// The value at the point of the linear function that minimises sum w (f(x_p) - u_p)^2: with
/// m = (1, (x_p - x)/h) and M = sum w m m^T, the share of a particle is w e_1 M^-1 m.
template <int D>
void Projection<D>::weigh_for_fits(std::span<const double> positions) {
  using Vector = Eigen::Matrix<double, D + 1, 1>;
  constexpr double singular = 1e-2;  // a spread of a tenth of the reach: beyond, noise grows
  std::vector<Vector> monomials;
  for (Index point = 0; point < mesh_.point_count(); ++point) {
    auto& shares = shares_[static_cast<std::size_t>(point)];
    double reach = 0;
    monomials.clear();
    for (const Share& share : shares) {
      const auto place = Vec<D>::Map(&positions[static_cast<std::size_t>(share.particle) * D]);
      monomials.push_back((Vector() << 1, place - mesh_.point(point)).finished());
      reach = std::max(reach, monomials.back().template tail<D>().norm());
    }
    Eigen::Matrix<double, D + 1, D + 1> moments = moments.Zero();
    for (std::size_t k = 0; k < shares.size(); ++k) {
      monomials[k].template tail<D>() /= reach;
      moments += shares[k].weight * monomials[k] * monomials[k].transpose();
    }
    const Eigen::LDLT<Eigen::Matrix<double, D + 1, D + 1>> factors(moments);
    if (shares.empty()) continue;
    if (!(factors.vectorD().minCoeff() > singular * factors.vectorD().maxCoeff())) {
      ++without_fit_;
      continue;
    }
    const Vector row = factors.solve(Vector::Unit(0));
    for (std::size_t k = 0; k < shares.size(); ++k) shares[k].weight *= row.dot(monomials[k]);
  }
}

/// In layers, each with the means of the layers before.
template <int D>
void Projection<D>::find_empty() {
  std::vector<bool> known(shares_.size());
  for (std::size_t point = 0; point < shares_.size(); ++point)
    known[point] = !shares_[point].empty();
  while (std::ranges::find(known, false) != known.end()) {
    std::vector<std::vector<Index>> from(known.size());
    for (Index c = 0; c < mesh_.cell_count(); ++c)
      for (const Index a : mesh_.cell(c).vertices)
        for (const Index b : mesh_.cell(c).vertices)
          if (!known[static_cast<std::size_t>(a)] && known[static_cast<std::size_t>(b)])
            from[static_cast<std::size_t>(a)].push_back(b);
    for (std::size_t point = 0; point < from.size(); ++point) {
      if (from[point].empty()) continue;
      std::ranges::sort(from[point]);
      const auto same = std::ranges::unique(from[point]);
      from[point].erase(same.begin(), same.end());
      empty_.push_back({static_cast<Index>(point), std::move(from[point])});
      known[point] = true;
    }
  }
}

template <int D>
std::vector<double> Projection<D>::project(std::span<const double> values) const {
  std::vector<double> projected(shares_.size() * D);
  const auto at = [&](Index point) {
    return Eigen::Map<Vec<D>>(&projected[static_cast<std::size_t>(point) * D]);
  };
  for (std::size_t point = 0; point < shares_.size(); ++point)
    for (const Share& share : shares_[point])
      at(static_cast<Index>(point)) +=
          share.weight * Vec<D>::Map(&values[static_cast<std::size_t>(share.particle) * D]);
  for (const Empty& empty : empty_) {
    for (const Index point : empty.from) at(empty.point) += at(point);
    at(empty.point) /= static_cast<double>(empty.from.size());
  }
  return projected;
}

template class Projection<2>;
template class Projection<3>;

}  // namespace mote
