#pragma once

#include <string>
#include <vector>

#include "mote/geometry/combined_shapes.hpp"
#include "mote/scenario/scenario.hpp"

namespace mote {

/// All of the shapes of a list together. Throws InputError, with the key of the shape, for corners
/// that make no polygon.
SharedShape union_of(const Scenario& scenario, const std::vector<ShapeSection>& sections,
                     const std::string& key);

/// The domain as a shape.
SharedShape whole_domain(const Scenario& scenario);

}  // namespace mote
