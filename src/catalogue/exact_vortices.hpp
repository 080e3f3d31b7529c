#pragma once

#include <memory>
#include <vector>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// The flows of vortices known in closed form.
std::vector<ExactEntry> vortex_entries();

/// Whether the set-up is one of the model of vortices, whose start is a vorticity.
bool starts_from_vorticity(const FlowSetup& setup);

/// Taylor-Green vortices from their vorticity, 2 U k sin(k x + a) sin(k y + b). Throws InputError
/// with the key `check.against`.
std::unique_ptr<FlowSolution> taylor_green_from_vorticity(const FlowSetup& setup);

}  // namespace mote
