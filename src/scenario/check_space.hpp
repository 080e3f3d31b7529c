#pragma once

#include "mote/scenario/scenario.hpp"

namespace mote {

/// Refuses dimensions and keys that do not belong to the scenario's model, and in space what no
/// single key of the domain, the regions and the particles can state. Throws LocatedError.
void check_line_or_space(const Scenario& scenario, const Document& document);

}  // namespace mote
