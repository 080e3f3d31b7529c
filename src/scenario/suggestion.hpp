#pragma once

#include <string>
#include <vector>

namespace mote {

/// ` (did you mean 'particles'?)` if one of the known words is close to `word`, else nothing.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

}  // namespace mote
