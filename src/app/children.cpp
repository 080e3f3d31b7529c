#include "mote/app/children.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

/// A program that is replaced while it runs is still itself here.
constexpr const char* this_program = "/proc/self/exe";

std::string last_line(const fs::path& file) {
  std::ifstream text(file);
  std::string last;
  for (std::string line; std::getline(text, line);)
    if (!line.empty()) last = line;
  return last;
}

/// How a run ended in words, unless it wrote a certificate.
std::string problem_of(int status, const fs::path& messages) {
  if (WIFSIGNALED(status))
    return fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  const int code = WEXITSTATUS(status);
  if (code == 0 || code == 1 || code == 3) return "";
  const std::string said = last_line(messages);
  return fmt::format("ended with exit code {}{}", code, said.empty() ? "" : ": " + said);
}

/// Both streams of the child into one file.
class IntoFile {
 public:
  explicit IntoFile(const fs::path& file) : name_(file.string()) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, name_.c_str(),
                                     O_CREAT | O_TRUNC | O_WRONLY, 0666);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~IntoFile() { posix_spawn_file_actions_destroy(&actions_); }
  IntoFile(const IntoFile&) = delete;
  IntoFile& operator=(const IntoFile&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  std::string name_;
  posix_spawn_file_actions_t actions_;
};

}  // namespace

void Children::start(std::size_t number, const std::vector<std::string>& arguments,
                     const fs::path& messages) {
  std::vector<std::string> words{"mote"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const IntoFile into(messages);
  pid_t child = 0;
  const int error =
      posix_spawn(&child, this_program, into.actions(), nullptr, pointers.data(), environ);
  if (error != 0) throw InputError(fmt::format("cannot start a run: {}", std::strerror(error)));
  running_.emplace(child, Child{number, messages});
}

EndedChild Children::wait_for_one() {
  int status = 0;
  pid_t ended = 0;
  do ended = wait(&status);
  while ((ended < 0 && errno == EINTR) || (ended > 0 && !running_.contains(ended)));
  if (ended < 0) throw InputError(fmt::format("cannot wait for a run: {}", std::strerror(errno)));
  const Child child = running_.extract(ended).mapped();
  EndedChild result{child.number, problem_of(status, child.messages)};
  std::error_code ignored;
  if (fs::file_size(child.messages, ignored) == 0) fs::remove(child.messages, ignored);
  return result;
}

}  // namespace mote
