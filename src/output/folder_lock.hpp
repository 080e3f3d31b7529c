#pragma once

#include <filesystem>

namespace mote {

/// Keeps other runs out of a folder for as long as it lives; a program that is killed lets go.
class FolderLock {
 public:
  /// Throws InputError if another run holds the folder or it cannot be opened.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace mote
