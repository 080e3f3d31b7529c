#include "mote/models/body_force.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

void require_components(std::size_t count, int dimension, const char* name, const char* what) {
  if (count == 0 || count == static_cast<std::size_t>(dimension)) return;
  throw InputError(
      std::string("model.") + name,
      fmt::format("'{}' needs {} {}, one a dimension, and has {}", name, dimension, what, count));
}

}  // namespace

void BodyForceOptions::describe(Description& d) {
  d.numbers({"gravity", "acceleration, one number a dimension; default: none"}, gravity);
  d.expressions({"force", "acceleration in x, y, z and t, one formula a dimension; default: none"},
                force);
}

template <int D>
BodyForce<D>::BodyForce(const BodyForceOptions& options, const SpaceStart& start) {
  require_components(options.gravity.size(), D, "gravity", "numbers");
  require_components(options.force.size(), D, "force", "formulas");
  if (!options.gravity.empty()) gravity_ = Vec<D>::Map(options.gravity.data());
  formulas_.resize(static_cast<std::size_t>(omp_get_max_threads()));
  for (auto& mine : formulas_)
    for (const std::string& formula : options.force) mine.push_back(start.compile(formula));
}

template <int D>
Vec<D> BodyForce<D>::at(const Vec<D>& position, double time) const {
  Vec<D> force = Vec<D>::Zero();
  if (!has_formulas()) return force;
  const auto& formulas = formulas_[static_cast<std::size_t>(omp_get_thread_num())];
  Triple place{};
  std::copy_n(position.data(), D, place.begin());
  for (int d = 0; d < D; ++d) force[d] = formulas[static_cast<std::size_t>(d)](place, time);
  return force;
}

template class BodyForce<2>;
template class BodyForce<3>;

}  // namespace mote
