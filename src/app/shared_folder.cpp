#include "mote/app/shared_folder.hpp"

namespace mote {

std::filesystem::path shared_folder() {
  std::error_code error;
  const auto program = std::filesystem::canonical("/proc/self/exe", error);
  const auto beside = program.parent_path().parent_path() / "share" / "mote";
  if (!error && std::filesystem::exists(beside)) return beside;
  return MOTE_SHARED_FOLDER;
}

}  // namespace mote
