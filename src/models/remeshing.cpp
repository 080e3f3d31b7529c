#include "mote/models/remeshing.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "mote/particles/failure.hpp"
#include "mote/particles/m4_prime.hpp"

namespace mote {
namespace {

/// Nodes of one axis that a vortex gives to, from `first` on, and how much to each.
struct AxisWeights {
  std::int64_t first = 0;
  std::vector<double> weights;
};

/// `place` in spacings from node 0 on.
void weigh_by_m4_prime(double place, AxisWeights& axis) {
  const double before = std::floor(place);
  axis.first = static_cast<std::int64_t>(before) - 1;
  const auto weights = m4_prime_weights(place - before);
  axis.weights.assign(weights.begin(), weights.end());
}

void weigh_by_gauss(double place, double deviation, AxisWeights& axis) {
  const auto reach = static_cast<std::int64_t>(std::ceil(8.5 * deviation));
  axis.first = static_cast<std::int64_t>(std::floor(place)) - reach;
  axis.weights.resize(static_cast<std::size_t>(2 * reach + 2));
  double sum = 0;
  for (std::size_t k = 0; k < axis.weights.size(); ++k) {
    const double s =
        (place - static_cast<double>(axis.first + static_cast<std::int64_t>(k))) / deviation;
    axis.weights[k] = std::exp(-0.5 * s * s);
    sum += axis.weights[k];
  }
  for (double& weight : axis.weights) weight /= sum;
}

/// Sums over vortices of circulation times 1, x - origin, and |x - origin|^2.
template <int D>
using Moments = Eigen::Matrix<double, D + 2, 1>;

template <int D>
class Lattice {
 public:
  static constexpr std::size_t strengths = VortexList<D>::strengths;
  using Strength = std::array<double, strengths>;

  Lattice(const VortexList<D>& vortices, const VortexLatticeOptions& options, double deviation)
      : vortices_(vortices), options_(options), deviation_(deviation) {
    in_a_box_ = options.cells[0] > 0;
    for (std::size_t i = 0; i < vortices.count(); ++i)
      origin_ += at(vortices, i) / static_cast<double>(vortices.count());
    for (std::size_t i = 0; i < vortices.count(); ++i)
      size_ = std::max(size_, (at(vortices, i) - origin_).norm());
  }

  VortexList<D> filled(RemeshingLoss* loss) {
    hand_out();
    collect();
    VortexList<D> kept = above_threshold(loss);
    for (std::size_t c = 0; c < strengths; ++c) restore_moments(c, kept);
    return kept;
  }

 private:
  struct Share {
    std::array<std::int32_t, D> node;  ///< along z, y, x: in this order nodes are sorted
    Strength strength;
  };

  static Vec<D> at(const VortexList<D>& list, std::size_t i) {
    return Vec<D>::Map(list.position.data() + i * D);
  }

  std::int32_t node(std::int64_t k, std::size_t axis) const {
    const std::int64_t cells = options_.cells[axis];
    if (cells > 0) return static_cast<std::int32_t>(((k % cells) + cells) % cells);
    constexpr std::int64_t most = 1 << 30;
    if (std::abs(k) > most)
      throw NumericalFailure("a vortex is so far away that no lattice holds it", {},
                             "the step is too long");
    return static_cast<std::int32_t>(k);
  }

  void hand_out() {
    std::array<AxisWeights, D> axes;
    for (std::size_t i = 0; i < vortices_.count(); ++i) {
      for (std::size_t d = 0; d < D; ++d) {
        const double place =
            (vortices_.position[i * D + d] - options_.lower[d]) / options_.spacing - 0.5;
        if (!std::isfinite(place) || std::abs(place) > 1e15) node(std::int64_t{1} << 40, d);
        if (deviation_ > 0)
          weigh_by_gauss(place, deviation_ / options_.spacing, axes[d]);
        else
          weigh_by_m4_prime(place, axes[d]);
      }
      hand_out_one(i, axes);
    }
  }

  void hand_out_one(std::size_t i, const std::array<AxisWeights, D>& axes) {
    std::array<std::size_t, D> k{};
    const std::size_t each = axes[0].weights.size();
    for (std::size_t all = std::size_t(std::pow(each, D)), n = 0; n < all; ++n) {
      Share share;
      double weight = 1;
      std::size_t rest = n;
      for (std::size_t d = 0; d < D; ++d, rest /= each) {
        k[d] = rest % each;
        weight *= axes[d].weights[k[d]];
        share.node[D - 1 - d] = node(axes[d].first + static_cast<std::int64_t>(k[d]), d);
      }
      if (weight == 0) continue;
      for (std::size_t c = 0; c < strengths; ++c)
        share.strength[c] = weight * vortices_.circulation[i * strengths + c];
      shares_.push_back(share);
    }
  }

  /// What each node gets, summed in the order of vortices.
  void collect() {
    std::ranges::stable_sort(shares_, {}, &Share::node);
    std::size_t nodes = 0;
    for (const Share& share : shares_) {
      if (nodes > 0 && shares_[nodes - 1].node == share.node)
        for (std::size_t c = 0; c < strengths; ++c)
          shares_[nodes - 1].strength[c] += share.strength[c];
      else
        shares_[nodes++] = share;
    }
    shares_.resize(nodes);
  }

  static double magnitude(const Strength& strength) {
    double square = 0;
    for (const double component : strength) square += component * component;
    return std::sqrt(square);
  }

  VortexList<D> above_threshold(RemeshingLoss* loss) const {
    double highest = 0, all = 0, dropped = 0;
    for (const Share& share : shares_) highest = std::max(highest, magnitude(share.strength));
    VortexList<D> kept;
    for (const Share& share : shares_) {
      const double size = magnitude(share.strength);
      all += size;
      if (size == 0 || size < options_.threshold * highest) {
        dropped += size;
        continue;
      }
      Vec<D> place;
      for (std::size_t d = 0; d < D; ++d)
        place[static_cast<Eigen::Index>(d)] =
            options_.lower[d] + (share.node[D - 1 - d] + 0.5) * options_.spacing;
      kept.add({place.data(), D}, share.strength);
    }
    if (loss != nullptr) loss->dropped = all > 0 ? dropped / all : 0;
    return kept;
  }

  /// 1, (x - origin)/size, |x - origin|^2/size^2; in a box, where places have no meaning, 1 alone.
  Moments<D> powers(const Vec<D>& place) const {
    const Vec<D> x = size_ > 0 ? Vec<D>((place - origin_) / size_) : Vec<D>(place - origin_);
    Moments<D> powers = Moments<D>::Zero();
    powers[0] = 1;
    if (in_a_box_) return powers;
    powers.template segment<D>(1) = x;
    powers[D + 1] = x.squaredNorm();
    return powers;
  }

  Moments<D> moments(const VortexList<D>& list, std::size_t c) const {
    Moments<D> sum = Moments<D>::Zero();
    for (std::size_t i = 0; i < list.count(); ++i)
      sum += list.circulation[i * strengths + c] * powers(at(list, i));
    return sum;
  }

  void restore_moments(std::size_t c, VortexList<D>& kept) const {
    Moments<D> wanted = moments(vortices_, c);
    if (!in_a_box_ && size_ > 0)
      wanted[D + 1] += D * deviation_ * deviation_ / (size_ * size_) * wanted[0];
    Eigen::Matrix<double, D + 2, D + 2> matrix = decltype(matrix)::Zero();
    for (std::size_t i = 0; i < kept.count(); ++i) {
      const Moments<D> p = powers(at(kept, i));
      matrix += std::abs(kept.circulation[i * strengths + c]) * p * p.transpose();
    }
    const Moments<D> lacking = wanted - moments(kept, c);
    const Moments<D> given = matrix.completeOrthogonalDecomposition().solve(lacking);
    for (std::size_t i = 0; i < kept.count(); ++i) {
      double& circulation = kept.circulation[i * strengths + c];
      circulation += std::abs(circulation) * given.dot(powers(at(kept, i)));
    }
  }

  const VortexList<D>& vortices_;
  const VortexLatticeOptions& options_;
  double deviation_;  ///< of the Gauss function; 0: M4'
  bool in_a_box_ = false;
  Vec<D> origin_ = Vec<D>::Zero();
  double size_ = 0;
  std::vector<Share> shares_;
};

}  // namespace

template <int D>
VortexList<D> remeshed(const VortexList<D>& vortices, const VortexLatticeOptions& lattice,
                       RemeshingLoss* loss) {
  return Lattice<D>(vortices, lattice, 0).filled(loss);
}

template <int D>
VortexList<D> spread_on_lattice(const VortexList<D>& vortices, const VortexLatticeOptions& lattice,
                                double deviation, RemeshingLoss* loss) {
  return Lattice<D>(vortices, lattice, deviation).filled(loss);
}

template VortexList<2> remeshed(const VortexList<2>&, const VortexLatticeOptions&, RemeshingLoss*);
template VortexList<2> spread_on_lattice(const VortexList<2>&, const VortexLatticeOptions&, double,
                                         RemeshingLoss*);
template VortexList<3> remeshed(const VortexList<3>&, const VortexLatticeOptions&, RemeshingLoss*);
template VortexList<3> spread_on_lattice(const VortexList<3>&, const VortexLatticeOptions&, double,
                                         RemeshingLoss*);

}  // namespace mote
