#include "mote/exact/flow_solution.hpp"

#include <limits>
#include <stdexcept>

namespace mote {

double FlowSolution::valid_until() const { return std::numeric_limits<double>::infinity(); }

Table FlowSolution::of_particles(double /*time*/) const {
  throw std::logic_error("a flow is known by place, not by particle");
}

}  // namespace mote
