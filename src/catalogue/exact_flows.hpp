#pragma once

#include <memory>
#include <vector>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// The flows known in closed form, each with how it is recognised in a model's initial state.
std::vector<ExactEntry> flow_entries();

/// How each is made. All throw InputError, with the key `check.against`, for a start that is not
/// that of the flow.
std::unique_ptr<FlowSolution> taylor_green_from(const FlowSetup& setup);
std::unique_ptr<FlowSolution> poiseuille_from(const FlowSetup& setup);
std::unique_ptr<FlowSolution> couette_from(const FlowSetup& setup);
std::unique_ptr<FlowSolution> hydrostatic_from(const FlowSetup& setup);
std::unique_ptr<FlowSolution> standing_wave_from(const FlowSetup& setup);
std::unique_ptr<FlowSolution> drop_from(const FlowSetup& setup);

}  // namespace mote
