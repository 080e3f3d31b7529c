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

/// The corners of a region in the plane that is one box, ball or polygon; a ball has the area of
/// its polygon, with sides no longer than `side`, and is symmetric about both axes. Empty for
/// others.
std::vector<Triple> outline_of(const RegionSection& region, double side);

/// The domain as a shape.
SharedShape whole_domain(const Scenario& scenario);

}  // namespace mote
