#include "mote/exact/flow_solution.hpp"

#include <limits>

namespace mote {

double FlowSolution::valid_until() const { return std::numeric_limits<double>::infinity(); }

}  // namespace mote
