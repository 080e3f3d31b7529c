#include "mote/particles/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/dimensions.hpp"

namespace mote::test {
namespace {

/// The draws of SplitMix64 (Steele, Lea, Flood 2014) by its own stream, one after the other.
std::vector<long double> stream(std::uint64_t seed, std::size_t count) {
  std::vector<long double> draws;
  while (draws.size() < count) {
    seed += 0x9E3779B97F4A7C15u;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    draws.push_back(std::ldexp(static_cast<long double>((z ^ (z >> 31)) >> 11), -53));
  }
  return draws;
}

/// A box whose sides, cells and numbers of cells all differ.
template <int D>
LatticeShape<D> box(double jitter, Index layers, LatticeExtension extension) {
  constexpr double lower[] = {-1, 0.5, 2}, upper[] = {3, 1.7, 2.6};
  constexpr Index count[] = {7, 4, 3};
  LatticeShape<D> shape{.jitter = jitter, .seed = 31, .layers = layers, .extension = extension};
  for (int d = 0; d < D; ++d) {
    shape.lower[d] = lower[d];
    shape.upper[d] = upper[d];
    shape.count[d] = count[d];
  }
  return shape;
}

using Cell = std::vector<Index>;
using Place = std::vector<long double>;

/// The points of a lattice from the words of its interface: every coordinate on its own, images by
/// turning or shifting the whole point.
template <int D>
class Reference {
 public:
  explicit Reference(const LatticeShape<D>& shape) : shape_(shape) {
    const Cell all = {0, 0, 0};
    visit(all, D - 1);
    const std::size_t points = inside_.size() + around_.size();
    draws_ = stream(shape.seed, points * D);
    for (std::size_t i = 0; i < inside_.size(); ++i) places.push_back(drawn(inside_[i], i));
    for (const Cell& cell : around_) places.push_back(outside(cell, places.size()));
  }

  std::vector<Place> places;
  std::size_t receivers() const { return inside_.size(); }

 private:
  /// All cells, the highest axis in the outermost loop.
  void visit(Cell cell, int axis) {
    if (axis < 0) {
      (is_inside(cell) ? inside_ : around_).push_back(cell);
      return;
    }
    for (cell[axis] = -shape_.layers; cell[axis] < shape_.count[axis] + shape_.layers; ++cell[axis])
      visit(cell, axis - 1);
  }

  bool is_inside(const Cell& cell) const {
    bool inside = true;
    for (int d = 0; d < D; ++d) inside = inside && cell[d] >= 0 && cell[d] < shape_.count[d];
    return inside;
  }

  long double side(int d) const {
    return (static_cast<long double>(shape_.upper[d]) - shape_.lower[d]) / shape_.count[d];
  }

  Place midpoint(const Cell& cell) const {
    Place place;
    for (int d = 0; d < D; ++d) place.push_back(shape_.lower[d] + (cell[d] + 0.5L) * side(d));
    return place;
  }

  Place drawn(const Cell& cell, std::size_t i) const {
    Place place = midpoint(cell);
    for (int d = 0; d < D; ++d)
      place[d] += shape_.jitter * (2 * draws_[i * D + static_cast<std::size_t>(d)] - 1) * side(d);
    return place;
  }

  std::size_t number_of(const Cell& cell) const {
    return static_cast<std::size_t>(std::ranges::find(inside_, cell) - inside_.begin());
  }

  Place outside(const Cell& cell, std::size_t i) const {
    switch (shape_.extension) {
      case LatticeExtension::formula:
        return drawn(cell, i);
      case LatticeExtension::constant:
        return midpoint(cell);
      case LatticeExtension::mirror:
        return mirrored(cell);
      case LatticeExtension::periodic:
        break;
    }
    return shifted(cell);
  }

  /// Reflects cell after cell into the box, then the point there all the way back.
  Place mirrored(Cell cell) const {
    std::vector<std::pair<int, long double>> mirrors;
    for (int d = 0; d < D; ++d)
      while (cell[d] < 0 || cell[d] >= shape_.count[d]) {
        const bool below = cell[d] < 0;
        mirrors.emplace_back(d, below ? shape_.lower[d] : shape_.upper[d]);
        cell[d] = (below ? 0 : 2 * shape_.count[d]) - 1 - cell[d];
      }
    Place place = places[number_of(cell)];
    for (auto mirror = mirrors.rbegin(); mirror != mirrors.rend(); ++mirror)
      place[mirror->first] = 2 * mirror->second - place[mirror->first];
    return place;
  }

  Place shifted(Cell cell) const {
    Place shift(D, 0);
    for (int d = 0; d < D; ++d) {
      const long double size = static_cast<long double>(shape_.upper[d]) - shape_.lower[d];
      for (; cell[d] < 0; cell[d] += shape_.count[d]) shift[d] -= size;
      for (; cell[d] >= shape_.count[d]; cell[d] -= shape_.count[d]) shift[d] += size;
    }
    Place place = places[number_of(cell)];
    for (int d = 0; d < D; ++d) place[d] += shift[d];
    return place;
  }

  const LatticeShape<D>& shape_;
  std::vector<Cell> inside_, around_;
  std::vector<long double> draws_;
};

/// Whether points are those of a shape, to a few units of rounding of the largest coordinate.
template <int D>
testing::AssertionResult are_points_of(const LatticeShape<D>& shape, const Points<D>& points) {
  const Reference<D> reference(shape);
  if (points.size() != static_cast<Index>(reference.places.size()) ||
      points.receivers != static_cast<Index>(reference.receivers()))
    return testing::AssertionFailure() << points.receivers << " of " << points.size();
  constexpr long double largest = 30, tolerance = 8 * 2.3e-16L * largest;
  long double volume = 1;
  for (int d = 0; d < D; ++d)
    volume *= (static_cast<long double>(shape.upper[d]) - shape.lower[d]) / shape.count[d];
  for (Index i = 0; i < points.size(); ++i) {
    for (int d = 0; d < D; ++d)
      if (!(std::abs(points.position[i * D + d] - reference.places[i][d]) <= tolerance))
        return testing::AssertionFailure()
               << "coordinate " << d << " of point " << i << " is " << points.position[i * D + d]
               << ", not " << reference.places[i][d];
    if (!(std::abs(std::pow(points.length[i], D) - volume) <= 1e-14L * volume))
      return testing::AssertionFailure() << "length of point " << i << " is " << points.length[i];
  }
  return testing::AssertionSuccess();
}

constexpr LatticeExtension extensions[] = {LatticeExtension::formula, LatticeExtension::constant,
                                           LatticeExtension::mirror, LatticeExtension::periodic};

template <class Dimension>
struct LatticeIn : testing::Test {
  static constexpr int D = Dimension::value;
};

TYPED_TEST_SUITE(LatticeIn, Dimensions, NameOfDimension);

/// 16 layers need images of images on every axis.
TYPED_TEST(LatticeIn, IsWhatItsWordsSay) {
  constexpr int D = TestFixture::D;
  for (const LatticeExtension extension : extensions)
    for (const double jitter : {0.0, 0.2, 0.5})
      for (const Index layers : {0, 1, 2, D == 3 ? 7 : 16}) {
        const auto shape = box<D>(jitter, layers, extension);
        EXPECT_TRUE(are_points_of(shape, lattice_points(shape)))
            << layers << " layers, jitter " << jitter << ", extension "
            << static_cast<int>(extension);
      }
}

TYPED_TEST(LatticeIn, OfOneCellIsItsMidpoint) {
  constexpr int D = TestFixture::D;
  auto shape = box<D>(0, 0, LatticeExtension::formula);
  shape.count.fill(1);
  const auto points = lattice_points(shape);
  ASSERT_EQ(points.size(), 1);
  EXPECT_LE((points.at(0) - (shape.lower + shape.upper) / 2).norm(), 1e-15);
}

/// The cells of the box are the same whatever lies around them.
TYPED_TEST(LatticeIn, DoesNotDependOnItsLayers) {
  constexpr int D = TestFixture::D;
  const auto alone = lattice_points(box<D>(0.3, 0, LatticeExtension::formula)).position;
  for (const LatticeExtension extension : extensions) {
    auto position = lattice_points(box<D>(0.3, 2, extension)).position;
    position.resize(alone.size());
    EXPECT_EQ(position, alone);
  }
}

TYPED_TEST(LatticeIn, CheckNoticesAnotherExtension) {
  constexpr int D = TestFixture::D;
  for (const LatticeExtension a : extensions)
    for (const LatticeExtension b : extensions)
      EXPECT_EQ(
          static_cast<bool>(are_points_of(box<D>(0.2, 2, a), lattice_points(box<D>(0.2, 2, b)))),
          a == b);
}

TYPED_TEST(LatticeIn, CheckNoticesAnotherSeedJitterOrOrder) {
  constexpr int D = TestFixture::D;
  const auto shape = box<D>(0.2, 1, LatticeExtension::formula);
  auto other = shape;
  other.seed = 32;
  EXPECT_FALSE(are_points_of(shape, lattice_points(other)));
  other = shape;
  other.jitter = 0.2000001;
  EXPECT_FALSE(are_points_of(shape, lattice_points(other)));
  auto points = lattice_points(shape);
  for (int d = 0; d < D; ++d) std::swap(points.position[d], points.position[D + d]);
  EXPECT_FALSE(are_points_of(shape, points));
}

}  // namespace
}  // namespace mote::test
