#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mote/output/folder_lock.hpp"

namespace mote {

/// What to do when an output folder is there already.
enum class Existing { refuse, replace };

/// A kind of output folder: how it is known, and what mote writes into it.
struct FolderKind {
  std::string what;       ///< `run`
  std::string mark_file;  ///< the file whose first line is `mark`
  std::string mark;
  std::vector<std::string> files;  ///< but for the mark file
};

/// A folder for new output, out of which others are kept as long as the claim lives.
class ClaimedFolder {
 public:
  /// Makes the folder, or takes one with former output of this kind if `existing` says so. Throws
  /// InputError.
  ClaimedFolder(const std::filesystem::path& path, Existing existing, FolderKind kind);

  /// Removes former output, its files and `more`, and nothing else. Throws InputError.
  void remove_former(const std::vector<std::filesystem::path>& more = {}) const;

  /// Gives the folder up after a failure: removes it if it is new and has nothing in it.
  void abandon();

  std::unique_ptr<FolderLock> take_lock() { return std::move(lock_); }

 private:
  std::filesystem::path path_;
  FolderKind kind_;
  bool is_new_;
  std::unique_ptr<FolderLock> lock_;
};

/// Makes a folder and those around it. Throws InputError.
void make_folder(const std::filesystem::path& path);

}  // namespace mote
