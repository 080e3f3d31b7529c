#include "mote/output/picture.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

namespace mote {
namespace {

/// Becomes the program, which ends with this process, or when its time is up: alarms outlive the
/// exec. Between fork and exec there is nothing but system calls, as other threads may run.
[[noreturn]] void become(char* const* arguments, unsigned seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  alarm(seconds);
  execv(arguments[0], arguments);
  _exit(127);
}

}  // namespace

std::string draw_pictures(const std::filesystem::path& path, const std::filesystem::path& folder,
                          unsigned seconds) {
  std::string script = path.string(), target = folder.string();
  if (!std::filesystem::exists(path)) return fmt::format("the script {} is missing", script);
  // The system's own Python: it has the Debian packages, a user's version manager may not.
  std::string python = "/usr/bin/python3";
  const std::array<char*, 4> arguments{python.data(), script.data(), target.data(), nullptr};
  const pid_t child = fork();
  if (child == 0) become(arguments.data(), seconds);
  if (child < 0) return "cannot start " + python;
  int status = 0;
  const bool ended = waitpid(child, &status, 0) == child;
  if (ended && WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return fmt::format("{} {} took longer than {} s", script, target, seconds);
  if (!ended || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return fmt::format("{} {} failed", script, target);
  return "";
}

}  // namespace mote
