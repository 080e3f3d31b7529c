#include "mote/exact/hydrostatic.hpp"

namespace mote {

std::string Hydrostatic::statement() const {
  return "hydrostatic is exact for a fluid of constant density that fills its tank to a level top";
}

Table Hydrostatic::at_places(std::span<const double> position, int dimension, double) const {
  return flow_table(position, dimension, WithPressure::yes, [&](const auto& place) {
    FlowState state;
    for (std::size_t d = 0; d < 3; ++d)
      state.pressure += density_ * gravity_[d] * (place[d] - surface_[d]);
    return state;
  });
}

}  // namespace mote
