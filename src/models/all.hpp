#pragma once

#include "mote/models/bodies_options.hpp"
#include "mote/models/incompressible_options.hpp"
#include "mote/models/pressureless_gas.hpp"
#include "mote/models/tracers_options.hpp"
#include "mote/models/vortex_options.hpp"
#include "mote/models/weakly_compressible_options.hpp"
#include "mote/options/type_list.hpp"

namespace mote {

/// The models of mote. A new one is its pair of files, a scenario and a word here.
using Models = TypeList<PressurelessGasRecipe, WeaklyCompressibleRecipe, IncompressibleRecipe,
                        VortexRecipe, BodiesRecipe, TracersRecipe>;

}  // namespace mote
