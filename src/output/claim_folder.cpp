#include "mote/output/claim_folder.hpp"

#include <fmt/format.h>

#include <fstream>

#include "mote/particles/failure.hpp"

namespace mote {
namespace fs = std::filesystem;

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw InputError(
        fmt::format("{}: cannot make this folder: {}", path.string(), error.message()));
}

ClaimedFolder::ClaimedFolder(const fs::path& path, Existing existing, FolderKind kind)
    : path_(path), kind_(std::move(kind)) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw InputError(fmt::format("{}: this is a file, not a folder", path.string()));
  is_new_ = !fs::exists(path, error) || fs::is_empty(path, error);
  if (!is_new_ && existing == Existing::refuse)
    throw InputError(
        fmt::format("{}: this folder exists and is not empty; --overwrite replaces a former {}",
                    path.string(), kind_.what));
  make_folder(path);
  lock_ = std::make_unique<FolderLock>(path);
  if (is_new_) return;
  std::string first_line;
  std::getline(std::ifstream(path / kind_.mark_file), first_line);
  if (first_line != kind_.mark)
    throw InputError(
        fmt::format("{}: this folder is not the output of a {}, so it is not "
                    "overwritten",
                    path.string(), kind_.what));
}

/// The mark file goes last: as long as it is there the folder is known.
void ClaimedFolder::remove_former(const std::vector<fs::path>& more) const {
  if (is_new_) return;
  std::vector<fs::path> files = more;
  for (const std::string& name : kind_.files) files.push_back(path_ / name);
  files.push_back(path_ / kind_.mark_file);
  std::error_code error;
  for (const fs::path& file : files)
    if (!error) fs::remove(file, error);
  if (error)
    throw InputError(fmt::format("{}: cannot remove the former {}: {}", path_.string(), kind_.what,
                                 error.message()));
}

void ClaimedFolder::abandon() {
  lock_.reset();
  std::error_code ignored;
  if (is_new_ && fs::is_empty(path_, ignored)) fs::remove(path_, ignored);
}

}  // namespace mote
