#include "mote/solvers/mpi_session.hpp"

#include <HYPRE_utilities.h>
#include <mpi.h>

#include <cstdlib>
#include <utility>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace mote {
namespace {

/// What makes Open MPI content with one process that nobody launched; others ignore it. Settings of
/// the user come first.
void choose_single_process() {
  for (const char* launched : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(launched) != nullptr) return;
  constexpr std::pair<const char*, const char*> settings[] = {
      {"OMPI_MCA_ess_singleton_isolated", "1"},    // no daemon beside this process
      {"OMPI_MCA_orte_create_session_dirs", "0"},  // no files, so none that it cannot write
      {"PMIX_MCA_gds", "hash"},                    // no shared memory
      {"OMPI_MCA_pml", "ob1"},                     // no search for fast networks
      {"OMPI_MCA_btl", "self"},
  };
  for (const auto& [name, value] : settings) setenv(name, value, 0);
}

/// While there is one, memory that is never given back is no leak of ours: Open MPI keeps some.
class ForeignMemory {
 public:
#ifdef __SANITIZE_ADDRESS__
  ForeignMemory() { __lsan_disable(); }
  ~ForeignMemory() { __lsan_enable(); }
#else
  ForeignMemory() {}
  ~ForeignMemory() {}
#endif
  ForeignMemory(const ForeignMemory&) = delete;
  ForeignMemory& operator=(const ForeignMemory&) = delete;
};

class Session {
 public:
  Session() {
    const ForeignMemory foreign;
    int started = 0;
    MPI_Initialized(&started);
    if (!started) {
      choose_single_process();
      int provided;
      MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
      ours_ = true;
    }
    HYPRE_Init();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() {
    const ForeignMemory foreign;
    int ended = 0;
    MPI_Finalized(&ended);
    if (ended) return;
    HYPRE_Finalize();
    if (ours_) MPI_Finalize();
  }

 private:
  bool ours_ = false;
};

}  // namespace

void begin_mpi() { static const Session session; }

}  // namespace mote
