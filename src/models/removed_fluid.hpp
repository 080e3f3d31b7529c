#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mote/models/space.hpp"

namespace mote {

/// The side of the domain that a particle is beyond by more than `margin`, by name; empty if it is
/// beyond none.
template <int D>
std::string_view side_left(const Vec<D>& position, const SpaceStart& domain, double margin);

/// What has left the domain and was taken out of a run.
template <int D>
class RemovedFluid {
 public:
  void add(double id, const Vec<D>& position, std::string_view side, double time);
  /// Counts what was taken out before the run was resumed.
  void resume(Index count);

  Index count() const { return count_; }
  /// A sentence that counts them and describes the first, if there are any.
  std::vector<std::string> warnings() const;

 private:
  Index count_ = 0;
  std::string first_;
};

extern template class RemovedFluid<2>;
extern template class RemovedFluid<3>;

}  // namespace mote
