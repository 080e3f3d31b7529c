#include <algorithm>

#include "mote/models/weakly_compressible.hpp"
#include "mote/operators/differential/apply.hpp"

namespace mote {

template <int D>
bool WeaklyCompressible<D>::uses_operator() const {
  return options_.pressure == Derivatives::by_operator ||
         options_.divergence == Derivatives::by_operator ||
         options_.viscosity == Viscosity::by_operator;
}

/// Numbers the fluid first and all else behind it, as operators want their receivers, and keeps of
/// the rows, which reach further than the operator, what it asks for.
template <int D>
void WeaklyCompressible<D>::prepare_operator() {
  const Index fluid = static_cast<Index>(std::ranges::count(idle_, 0));
  const auto size = static_cast<Index>(lines_.size());
  points_.resize(size, fluid);
  number_.resize(lines_.size());
  Index next_fluid = 0, next_other = fluid;
  for (Index i = 0; i < size; ++i) {
    const bool receiver = i < cloud_.count() && !is_wall(i);
    const Index k = number_[static_cast<std::size_t>(i)] = receiver ? next_fluid++ : next_other++;
    const Line& line = lines_[static_cast<std::size_t>(i)];
    Vec<D>::Map(points_.position.data() + std::ptrdiff_t{k} * D) = line.place();
    points_.mass[k] = mass_;
    points_.density[k] = mass_ / line.value[Line::volume];
    points_.length[k] = start_.spacing;
  }
  const NeighbourRule rule = operator_->neighbour_rule();
  std::size_t longest = 0;
  for (Index i = 0; i < cloud_.count(); ++i)
    longest = std::max(longest, neighbours_.lists()[i].size());
  operator_lists_.restart(fluid, longest);
  NeighbourLists::Writer writer(operator_lists_);
  for (Index i = 0; i < cloud_.count(); ++i) {
    if (is_wall(i)) continue;
    const Vec<D> place = lines_[static_cast<std::size_t>(i)].place();
    const auto neighbours = neighbours_.lists()[i];
    Index* const list = writer.room(neighbours.size());
    Index* end = list;
    for (const Index j : neighbours)
      if (rule.accepts((place - lines_[static_cast<std::size_t>(j)].place()).norm(), start_.spacing,
                       start_.spacing))
        *end++ = number_[static_cast<std::size_t>(j)];
    writer.close(number_[static_cast<std::size_t>(i)], end);
  }
  operator_->prepare(points_, operator_lists_);
}

/// Terms by the scenario's operator, for the fluid: -grad p/rho, -rho div u, nu lap u.
template <int D>
void WeaklyCompressible<D>::add_operator_terms() {
  if (!uses_operator()) return;
  prepare_operator();
  lines_of_operator_.resize(lines_.size());
  carrying_of_operator_.resize(lines_.size());
  receiver_of_operator_.resize(static_cast<std::size_t>(points_.receivers));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto k = static_cast<std::size_t>(number_[i]);
    lines_of_operator_[k] = lines_[i];
    carrying_of_operator_[k] = points_of_pairs().carrying_velocity(i);
    if (k < receiver_of_operator_.size()) receiver_of_operator_[k] = static_cast<Index>(i);
  }
  if (options_.pressure == Derivatives::by_operator ||
      options_.divergence == Derivatives::by_operator)
    add_first_derivatives();
  if (options_.viscosity == Viscosity::by_operator) add_laplacian();
}

template <int D>
void WeaklyCompressible<D>::add_first_derivatives() {
  const bool pressure = options_.pressure == Derivatives::by_operator;
  const bool divergence = options_.divergence == Derivatives::by_operator;
  for_each_row<Vec<D>>(operator_lists_, [&](Index k, auto neighbours, auto weights) {
    operator_->gradient_weights(k, weights);
    const Line& own = lines_of_operator_[static_cast<std::size_t>(k)];
    const Vec<D>& velocity = carrying_of_operator_[static_cast<std::size_t>(k)];
    Vec<D> slope = Vec<D>::Zero();
    double spreading = 0;
    for (std::size_t n = 0; n < neighbours.size(); ++n) {
      const auto other = static_cast<std::size_t>(neighbours[n]);
      slope += weights[n] *
               (lines_of_operator_[other].value[Line::pressure] - own.value[Line::pressure]);
      spreading += weights[n].dot(carrying_of_operator_[other] - velocity);
    }
    PairSums& sums = sums_of_receiver(k);
    const double density = mass_ / own.value[Line::volume];
    if (pressure) Vec<D>::Map(sums.value.data()) -= slope / density;
    if (divergence) sums.value[PairSums::rate] -= spreading;
  });
}

template <int D>
void WeaklyCompressible<D>::add_laplacian() {
  for_each_row<double>(operator_lists_, [&](Index k, auto neighbours, auto weights) {
    operator_->laplacian_weights(k, weights);
    const Vec<D> own = lines_of_operator_[static_cast<std::size_t>(k)].speed();
    Vec<D> sum = Vec<D>::Zero();
    for (std::size_t n = 0; n < neighbours.size(); ++n)
      sum +=
          weights[n] * (lines_of_operator_[static_cast<std::size_t>(neighbours[n])].speed() - own);
    Vec<D>::Map(sums_of_receiver(k).value.data()) += options_.kinematic_viscosity * sum;
  });
}

template class WeaklyCompressible<2>;
template class WeaklyCompressible<3>;

}  // namespace mote
