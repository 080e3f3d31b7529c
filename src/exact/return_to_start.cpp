#include "mote/exact/return_to_start.hpp"

#include <stdexcept>

namespace mote {

Table ReturnToStart::at_places(std::span<const double> /*position*/, int /*dimension*/,
                               double /*time*/) const {
  throw std::logic_error("the state at the start is known by particle, not by place");
}

Table ReturnToStart::of_particles(double /*time*/) const {
  Table table;
  for (const auto& [name, values] : {std::pair{"position_", &position_}, {"velocity_", &velocity_}})
    for (std::size_t d = 0; d < dimension_; ++d) {
      table.push_back({std::string(name) + "xyz" [d], {}});
      for (std::size_t k = d; k < values->size(); k += dimension_)
        table.back().values.push_back((*values)[k]);
    }
  return table;
}

}  // namespace mote
