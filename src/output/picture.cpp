#include "mote/output/picture.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

namespace mote {

std::string draw_pictures(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const std::string script = path.string(), target = folder.string();
  if (!std::filesystem::exists(path)) return fmt::format("the script {} is missing", script);
  // The system's own Python: it has the Debian packages, a user's version manager may not.
  std::string python = "/usr/bin/python3", script_argument = script, folder_argument = target;
  const std::array<char*, 4> arguments{python.data(), script_argument.data(),
                                       folder_argument.data(), nullptr};
  pid_t child = 0;
  if (posix_spawn(&child, python.c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
    return "cannot start " + python;
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return fmt::format("{} {} failed", script, target);
  return "";
}

}  // namespace mote
