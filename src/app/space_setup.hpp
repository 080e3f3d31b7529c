#pragma once

#include "mote/geometry/space_plan.hpp"
#include "mote/scenario/scenario.hpp"

namespace mote {

/// The scenario's domain, walls and regions as shapes. Throws InputError for corners that make no
/// polygon.
SpacePlan space_plan(const Scenario& scenario);

/// All that a model in space is made from but the operator and the search. Throws InputError as
/// `filled` does.
SpaceStart space_start(const Scenario& scenario);

/// What the scenario's model in space is made from; takes its operator.
SpaceSetup space_setup(Scenario& scenario, const Catalogue& catalogue);

/// Memory of a run in space, at most about. Throws InputError as `most_particles` does. [bytes]
double memory_in_space(const Scenario& scenario);

/// What its model needs beside the particles. Throws InputError as `ModelRecipe::other_memory`.
OtherMemory other_memory_in_space(const Scenario& scenario);

}  // namespace mote
