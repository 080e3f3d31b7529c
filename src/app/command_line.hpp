#pragma once

#include "mote/catalogue/entries.hpp"

namespace mote {

/// The program: reads the command line and runs the command with what the catalogue holds. Errors
/// go to standard error. Returns the exit code: 0 ran and every check passed, 1 a check failed,
/// 2 bad input, 3 the numerics failed.
int command_line(const Catalogue& catalogue, int argc, const char* const* argv);

}  // namespace mote
