#include "mote/scenario/suggestion.hpp"

#include <algorithm>
#include <numeric>

namespace mote {
namespace {

/// Number of letters to insert, delete or replace to get from a to b (Levenshtein).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
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
