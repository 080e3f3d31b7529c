#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mote {

/// A copy of this program that has ended.
struct EndedChild {
  std::size_t number = 0;  ///< that it was started with
  std::string problem;     ///< in words, if it neither ran to its end nor reported a failure
};

/// Copies of this program, each running one command. They share this program's process group, so
/// that an interrupt at the terminal ends them too.
class Children {
 public:
  /// Starts one; what it prints goes into the file `messages`, which goes if it stays empty. Throws
  /// InputError if there can be no further process.
  void start(std::size_t number, const std::vector<std::string>& arguments,
             const std::filesystem::path& messages);

  /// Waits until one of them ends; there must be one.
  EndedChild wait_for_one();

  std::size_t running() const { return running_.size(); }

 private:
  struct Child {
    std::size_t number;
    std::filesystem::path messages;
  };
  std::map<pid_t, Child> running_;
};

}  // namespace mote
