#include "mote/scenario/suggestion.hpp"

#include <algorithm>

namespace mote {
namespace {

/// Number of letters to insert, delete, replace or swap with the next to get from a to b
/// (Damerau's distance, no letter touched twice).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> distance(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      auto& best = distance[i][j];
      if (i == 0 || j == 0) {
        best = i + j;
        continue;
      }
      best = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      best = std::min({best, distance[i - 1][j] + 1, distance[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        best = std::min(best, distance[i - 2][j - 2] + 1);
    }
  return distance[a.size()][b.size()];
}

}  // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const auto closest = std::ranges::min_element(
      known, {}, [&](const std::string& other) { return edit_distance(word, other); });
  if (closest == known.end()) return "";
  const std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
  if (edit_distance(word, *closest) > allowed) return "";
  return " (did you mean '" + *closest + "'?)";
}

}  // namespace mote
