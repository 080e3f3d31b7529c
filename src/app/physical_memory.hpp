#pragma once

namespace mote {

/// Bytes of memory that this machine has.
double physical_memory();

}  // namespace mote
