#include "mote/compare/variations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

struct Unvaried {
  const char* key;
  const char* reason;
};
constexpr std::array<Unvaried, 4> unvaried{
    {{"compare", "it says what is varied"},
     {"threads", "--threads and --jobs share the processors out"},
     {"output.picture", "a comparison has one picture, and its members have none"},
     {"version", "it is a record"}}};

bool is_or_holds(const std::string& path, const std::string& other) {
  return other == path || other.starts_with(path + ".");
}

void refuse_unvaried(const std::string& path, const Origin& origin) {
  for (const auto& [key, reason] : unvaried)
    if (is_or_holds(key, path))
      throw LocatedError(origin.text, fmt::format("'{}' cannot be varied: {}", path, reason));
}

/// Parses the values as a list, so that a comma inside brackets does not part them.
void add(Document& document, const std::string& variation, std::set<std::string>& seen) {
  const Origin origin{"--vary " + variation};
  const auto equals = variation.find('=');
  if (equals == std::string::npos || equals == 0)
    throw LocatedError(origin.text, "this must have the form key.path=value,value,...");
  const std::string path = variation.substr(0, equals);
  const Value values = Document::parsed(fmt::format("[{}]", variation.substr(equals + 1)), origin);
  if (!seen.insert(path).second)
    throw LocatedError(origin.text, fmt::format("'{}' is varied twice", path));
  document.set({"compare", "vary", path}, values, origin);
}

/// What `--set` gives to a varied key, or below one, would be replaced without a word.
void refuse_lost(const std::string& assignment, const std::string& path) {
  const std::string key = assignment.substr(0, assignment.find('='));
  if (is_or_holds(path, key))
    throw LocatedError("--set " + assignment,
                       fmt::format("'{}' is varied, so this would have no effect", path));
}

}  // namespace

void vary(Document& document, const std::vector<std::string>& variations,
          const std::vector<std::string>& assignments) {
  std::set<std::string> seen;
  for (const std::string& variation : variations) add(document, variation, seen);
  const Value* varied = document.find({"compare", "vary"});
  if (varied == nullptr) return;
  for (const auto& entry : varied->entries) {
    refuse_unvaried(entry.key, entry.origin);
    for (const std::string& assignment : assignments) refuse_lost(assignment, entry.key);
  }
}

}  // namespace mote
