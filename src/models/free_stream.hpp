#pragma once

#include <string>
#include <vector>

#include "mote/models/space.hpp"

namespace mote {

/// The velocity u_infinity of (38), Isshiki (2014), by formulas in x, y, z and t.
template <int D>
class FreeStream {
 public:
  /// `formulas` holds one a dimension, or none. Throws InputError for another number, with the key
  /// of the model that they stand at.
  FreeStream(const std::vector<std::string>& formulas, const SpaceStart& start,
             const std::string& key = "free_stream");

  bool exists() const { return !formulas_.front().empty(); }
  /// Adds it to the velocities at these places.
  void add(std::span<const double> position, double time, std::span<double> velocity) const;
  /// Adds its gradient there, du_a/dx_b at place D a + b, by differences.
  void add_gradient(std::span<const double> position, double time,
                    std::span<double> gradient) const;

 private:
  double step_;                                       ///< of the differences
  std::vector<std::vector<PlaceFunction>> formulas_;  ///< for every thread, one a dimension
};

extern template class FreeStream<2>;
extern template class FreeStream<3>;

}  // namespace mote
