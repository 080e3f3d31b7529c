#pragma once

#include <string>

#include "mote/scenario/expression.hpp"

namespace mote {

/// The exact derivative of a formula with respect to x, y or z, as a formula that `Expression`
/// reads with the same constants; found by GiNaC. Throws ExpressionError for a formula that has no
/// symbolic derivative here (a condition, clamp, min, ...), with a message that says which part.
std::string derivative_of(const std::string& formula, char variable, const Constants& constants);

}  // namespace mote
