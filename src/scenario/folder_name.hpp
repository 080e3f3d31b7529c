#pragma once

#include <string>

namespace mote {

/// What keeps `name` from naming an output folder; empty if nothing does.
std::string folder_name_problem(const std::string& name);

}  // namespace mote
