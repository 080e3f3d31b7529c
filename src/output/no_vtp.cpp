#include "mote/output/tables.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

void write_vtp(const std::filesystem::path& path, const Cloud&) {
  throw InputError(path.string() +
                   ": this mote was built without VTK and cannot write .vtp; write .csv");
}

}  // namespace mote
