#include "mote/particles/lattice.hpp"

#include <cmath>

#include "mote/particles/images.hpp"
#include "mote/particles/random.hpp"

namespace mote {
namespace {

template <int D>
using CellNumbers = std::array<Index, D>;

/// A lattice and the places of its points.
template <int D>
class Lattice {
 public:
  explicit Lattice(const LatticeShape<D>& shape) : shape_(shape), cell_(shape.cell()) {}

  Points<D> points() const {
    std::vector<CellNumbers<D>> inside, around;
    for_each_cell(
        [&](const CellNumbers<D>& cell) { (is_inside(cell) ? inside : around).push_back(cell); });
    Points<D> points;
    const auto receivers = static_cast<Index>(inside.size());
    points.resize(receivers + static_cast<Index>(around.size()), receivers);
    Index i = 0;
    for (const auto* cells : {&inside, &around})
      for (const CellNumbers<D>& cell : *cells) {
        Vec<D>::Map(points.position.data() + std::ptrdiff_t{i} * D) = place(cell, i);
        points.length[i++] = std::pow(shape_.volume(), 1.0 / D);
      }
    return points;
  }

 private:
  template <class Visit>
  void for_each_cell(Visit visit) const {
    CellNumbers<D> cell;
    cell.fill(-shape_.layers);
    while (true) {
      visit(cell);
      int d = 0;
      while (d < D && ++cell[d] == shape_.count[d] + shape_.layers) cell[d++] = -shape_.layers;
      if (d == D) return;
    }
  }

  bool is_inside(const CellNumbers<D>& cell) const {
    for (int d = 0; d < D; ++d)
      if (cell[d] < 0 || cell[d] >= shape_.count[d]) return false;
    return true;
  }

  Vec<D> place(const CellNumbers<D>& cell, Index i) const {
    Vec<D> midpoint;
    for (int d = 0; d < D; ++d) midpoint[d] = shape_.lower[d] + (cell[d] + 0.5) * cell_[d];
    return midpoint + move(cell, i);
  }

  Vec<D> move(const CellNumbers<D>& cell, Index i) const {
    Vec<D> move = Vec<D>::Zero();
    if (shape_.jitter == 0) return move;
    CellNumbers<D> source = cell;
    Vec<D> sign = Vec<D>::Ones();
    if (!is_inside(cell)) switch (shape_.extension) {
        case LatticeExtension::constant:
          return move;
        case LatticeExtension::formula:
          break;
        case LatticeExtension::mirror:
          reflect(source, sign);
          i = number(source);
          break;
        case LatticeExtension::periodic:
          for (int d = 0; d < D; ++d) source[d] = periodic_image(cell[d], shape_.count[d]);
          i = number(source);
          break;
      }
    for (int d = 0; d < D; ++d) {
      const auto draw = static_cast<std::uint64_t>(i) * D + static_cast<std::uint64_t>(d);
      move[d] = sign[d] * shape_.jitter * (2 * uniform_random(shape_.seed, draw) - 1) * cell_[d];
    }
    return move;
  }

  /// The cell inside of which `cell` is the image, and the direction of its moves.
  void reflect(CellNumbers<D>& cell, Vec<D>& sign) const {
    for (int d = 0; d < D; ++d) {
      const MirrorImage image = mirror_image(cell[d], shape_.count[d]);
      cell[d] = image.cell;
      if (image.reversed) sign[d] = -1;
    }
  }

  /// Number of the point in a cell inside.
  Index number(const CellNumbers<D>& cell) const {
    Index number = 0;
    for (int d = D; d-- > 0;) number = number * shape_.count[d] + cell[d];
    return number;
  }

  const LatticeShape<D>& shape_;
  Vec<D> cell_;
};

}  // namespace

template <int D>
Vec<D> LatticeShape<D>::cell() const {
  Vec<D> sides = upper - lower;
  for (int d = 0; d < D; ++d) sides[d] /= count[d];
  return sides;
}

template <int D>
Points<D> lattice_points(const LatticeShape<D>& shape) {
  return Lattice<D>(shape).points();
}

template struct LatticeShape<1>;
template struct LatticeShape<2>;
template struct LatticeShape<3>;
template Points<1> lattice_points(const LatticeShape<1>&);
template Points<2> lattice_points(const LatticeShape<2>&);
template Points<3> lattice_points(const LatticeShape<3>&);

}  // namespace mote
