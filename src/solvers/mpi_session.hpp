#pragma once

namespace mote {

/// Starts MPI and hypre for this process, once, unless somebody did; both end with the process.
/// Without a launcher MPI starts no daemon, writes no files and uses no network (with Open MPI, in
/// 0.03 s), and it may run as root.
void begin_mpi();

}  // namespace mote
