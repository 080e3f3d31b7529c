#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace mote::test {

namespace fs = std::filesystem;

/// A folder of its own for one test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "mote_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::permissions(path_, fs::perms::owner_all, ignored);
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

inline std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline fs::path write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// What a program left behind. `exit_code` is 128 + the signal for one that was killed.
struct Outcome {
  int exit_code;
  std::string output, errors;
};

/// A running mote, its output in files of its own folder.
class Program {
 public:
  explicit Program(const std::vector<std::string>& arguments,
                   const std::string& program = MOTE_PROGRAM) {
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    const auto out = (folder_ / "out").string(), err = (folder_ / "err").string();
    posix_spawn_file_actions_addopen(&files, 1, out.c_str(), O_CREAT | O_WRONLY, 0600);
    posix_spawn_file_actions_addopen(&files, 2, err.c_str(), O_CREAT | O_WRONLY, 0600);
    const int error = posix_spawn(&child_, program.c_str(), &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw std::runtime_error("cannot start " + program);
  }

  void kill() const { ::kill(child_, SIGKILL); }

  Outcome wait() const {
    int status = 0;
    waitpid(child_, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, read(folder_ / "out"), read(folder_ / "err")};
  }

 private:
  TemporaryFolder folder_;
  pid_t child_ = 0;
};

/// Runs mote with these arguments to its end.
inline Outcome mote(const std::vector<std::string>& arguments) { return Program(arguments).wait(); }

/// Waits until a file exists; false after `seconds`.
inline bool wait_for_file(const fs::path& path, double seconds = 20) {
  for (int k = 0; k < seconds * 1000; ++k) {
    if (fs::exists(path)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

/// The arguments of `mote run` of one of our scenarios, without a picture.
inline std::vector<std::string> run_arguments(const std::string& scenario, const fs::path& out,
                                              const std::vector<std::string>& assignments = {}) {
  std::vector<std::string> arguments{"run",   std::string(MOTE_SCENARIOS "/") + scenario,
                                     "--out", out.string(),
                                     "--set", "output.picture=false"};
  for (const auto& assignment : assignments) {
    arguments.emplace_back("--set");
    arguments.push_back(assignment);
  }
  return arguments;
}

}  // namespace mote::test
