#pragma once

#include <string>
#include <vector>

#include "mote/models/space.hpp"
#include "mote/options/description.hpp"

namespace mote {

/// What accelerates all of a fluid alike, as a scenario states it.
struct BodyForceOptions {
  std::vector<double> gravity;     ///< one number a dimension, or none
  std::vector<std::string> force;  ///< one formula a dimension, or none

  void describe(Description& description);
};

/// Gravity, and a force per mass by formulas.
template <int D>
class BodyForce {
 public:
  /// Throws InputError for another number of components than dimensions.
  BodyForce(const BodyForceOptions& options, const SpaceStart& start);

  const Vec<D>& gravity() const { return gravity_; }
  bool has_formulas() const { return !formulas_.front().empty(); }
  /// By the formulas alone; zero without. To be called by any thread of those there were at the
  /// start.
  Vec<D> at(const Vec<D>& position, double time) const;

 private:
  Vec<D> gravity_ = Vec<D>::Zero();
  std::vector<std::vector<PlaceFunction>> formulas_;  ///< for every thread, one a dimension
};

extern template class BodyForce<2>;
extern template class BodyForce<3>;

}  // namespace mote
