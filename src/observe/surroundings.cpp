#include "mote/observe/surroundings.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>

#include "mote/operators/kernels/wendland_c2.hpp"

namespace mote {
namespace {

/// A tenth of a spacing, squared and in units of sight.
constexpr double least_spread = 0.01 / (sight * sight);

/// Calls `visit` with every image of a place, itself included, that is in the box.
template <int D, class Visit>
void for_each_image(const Vec<D>& place, const Triple& period, const Box<D>& box, int axis,
                    const Visit& visit) {
  if (axis == D) return visit(place);
  const double width = period[static_cast<std::size_t>(axis)];
  for (int turn = width > 0 ? -1 : 0; turn <= (width > 0 ? 1 : 0); ++turn) {
    Vec<D> image = place;
    image[axis] += turn * width;
    if (image[axis] < box.lower[axis] || image[axis] > box.upper[axis]) continue;
    for_each_image<D>(image, period, box, axis + 1, visit);
  }
}

}  // namespace

template <int D>
Surroundings<D>::Surroundings(const Model& model, const Triple& period, const Box<D>& box)
    : spacing_(model.spacing()) {
  const Vec<D> reach = Vec<D>::Constant(sight * spacing_);
  const Box<D> wide{box.lower - reach, box.upper + reach};
  const Cloud& cloud = model.cloud();
  const auto body = cloud.values("body");
  for (Index i = 0; i < cloud.count(); ++i) {
    const auto number = static_cast<std::size_t>(body[static_cast<std::size_t>(i)]);
    auto& seen = model.bodies()[number].kind == BodyKind::fluid ? fluid_ : walls_;
    const Vec<D> place = Vec<D>::Map(cloud.position().data() + std::ptrdiff_t{i} * D);
    for_each_image<D>(place, period, wide, 0, [&](const Vec<D>& image) {
      seen.push_back({image, i});
    });
  }
}

template <int D>
double Surroundings<D>::kernel(const Vec<D>& from, const Vec<D>& to) const {
  const double square = (to - from).squaredNorm(), reach = sight * spacing_;
  if (square >= reach * reach) return 0;
  return WendlandC2<D>::value(std::sqrt(square) * WendlandC2<D>::support() / reach);
}

template <int D>
std::vector<Share> Surroundings<D>::shares(const Vec<D>& place) const {
  std::vector<Share> shares;
  std::vector<Vec<D>> away;  // from the mean place, in units of sight
  double sum = 0;
  Vec<D> mean = Vec<D>::Zero();
  for (const auto& [position, particle] : fluid_) {
    const double weight = kernel(place, position);
    if (weight <= 0) continue;
    away.push_back((position - place) / (sight * spacing_));
    shares.push_back({particle, weight});
    sum += weight;
    mean += weight * away.back();
  }
  mean /= sum;
  Mat<D> spread = Mat<D>::Zero();
  for (std::size_t k = 0; k < shares.size(); ++k) {
    shares[k].part /= sum;
    away[k] -= mean;
    spread += shares[k].part * away[k] * away[k].transpose();
  }
  if (shares.empty()) return shares;
  const Eigen::SelfAdjointEigenSolver<Mat<D>> axes(spread, Eigen::EigenvaluesOnly);
  if (axes.eigenvalues()[0] < least_spread) return shares;
  // The place lies at -mean from the mean place: value = sum part f (1 - mean . spread^-1 away).
  const Vec<D> slope = spread.inverse() * mean;
  for (std::size_t k = 0; k < shares.size(); ++k) shares[k].part *= 1 - slope.dot(away[k]);
  return shares;
}

template <int D>
double Surroundings<D>::filled(const Vec<D>& place) const {
  // More wall than this leaves too little to speak of what fills it.
  constexpr double inside_wall = 0.9;
  const double scale = std::pow(WendlandC2<D>::support() / sight, D);  // V/h^D
  double fluid = 0, wall = 0;
  for (const auto& seen : walls_) wall += scale * kernel(place, seen.position);
  if (wall > inside_wall) return 0;
  for (const auto& seen : fluid_) fluid += scale * kernel(place, seen.position);
  return fluid / (1 - wall);
}

template class Surroundings<2>;
template class Surroundings<3>;

}  // namespace mote
