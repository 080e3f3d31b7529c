#include "mote/output/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "mote/particles/failure.hpp"

namespace mote {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0)
    throw InputError(fmt::format("{}: cannot open this folder", folder.string()));
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(descriptor_);
  throw InputError(fmt::format("{}: another run is writing into this folder", folder.string()));
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace mote
