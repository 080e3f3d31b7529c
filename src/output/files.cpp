#include "mote/output/files.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "mote/particles/failure.hpp"

namespace mote {

namespace fs = std::filesystem;

fs::path unfinished(const fs::path& path) {
  return path.parent_path() / (path.filename().string() + ".part");
}

void finish(const fs::path& path) {
  std::error_code error;
  fs::rename(unfinished(path), path, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(unfinished(path), ignored);
  throw InputError(fmt::format("{}: cannot write: {}", path.string(), error.message()));
}

void write_file(const fs::path& path, const std::string& contents) {
  {
    std::ofstream file(unfinished(path), std::ios::binary);
    file << contents;
    if (!file.flush()) throw InputError(fmt::format("{}: cannot write this file", path.string()));
  }
  finish(path);
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file.is_open()) throw InputError(fmt::format("{}: cannot read this file", path.string()));
  return text.str();
}

}  // namespace mote
