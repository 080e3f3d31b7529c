#include "mote/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mote/particles/failure.hpp"
#include "mote/scenario/version.hpp"

namespace mote {
namespace {

/// Keys along which errors fall by a power, the preferred one first.
constexpr const char* refinement_keys[] = {"particles.count", "time.step"};

/// A value as part of a folder's name.
std::string in_a_folder_name(const std::string& value) {
  std::string name;
  for (const unsigned char c : value)
    if (std::isalnum(c) != 0 || c == '.' || c == '-')
      name += static_cast<char>(c);
    else if (!name.empty() && name.back() != '_')
      name += '_';
  while (name.ends_with('_')) name.pop_back();
  return name.substr(0, 40);
}

std::string folder_of(std::size_t number, std::size_t count, const Member& member) {
  const std::size_t digits = std::max<std::size_t>(2, fmt::formatted_size("{}", count));
  std::string name = fmt::format("{:0{}}", number, digits);
  for (const std::string& value : member.values)
    name += fmt::format("-{}", in_a_folder_name(value));
  return "runs/" + name.substr(0, 120);
}

std::size_t number_of_members(const std::vector<PathValues>& vary) {
  double count = 1;
  for (const PathValues& varied : vary) count *= static_cast<double>(varied.values.size());
  if (count > static_cast<double>(most_members))
    throw InputError(fmt::format("a comparison has at most {} members, and this has {:.0f}",
                                 most_members, count));
  return static_cast<std::size_t>(count);
}

/// The k-th combination, counted like digits.
Member member_of(const std::vector<PathValues>& vary, std::size_t k, std::size_t count) {
  Member member;
  member.values.resize(vary.size());
  std::size_t rest = k;
  for (std::size_t place = vary.size(); place-- > 0; rest /= vary[place].values.size())
    member.values[place] = vary[place].values[rest % vary[place].values.size()];
  member.folder = folder_of(k + 1, count, member);
  return member;
}

/// Places of the varied keys so that a section comes before the keys in it, which it would replace.
std::vector<std::size_t> outer_keys_first(const std::vector<PathValues>& vary) {
  std::vector<std::size_t> places(vary.size());
  std::iota(places.begin(), places.end(), 0);
  std::ranges::stable_sort(
      places, {}, [&](std::size_t place) { return std::ranges::count(vary[place].path, '.'); });
  return places;
}

/// `sph.gauss` with a key added by `--set` has no form of its own in YAML.
void replace_short_forms(Value& value, const Value* resolved) {
  if (resolved == nullptr) return;
  if (!value.short_form.empty())
    value = *resolved;
  else
    for (auto& entry : value.entries) replace_short_forms(entry.value, resolved->find(entry.key));
}

std::string words(const Comparison& comparison, const Member& member,
                  std::optional<std::size_t> left_out) {
  std::string text;
  for (std::size_t place = 0; place < member.values.size(); ++place)
    if (place != left_out)
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", comparison.vary[place].path,
                          member.values[place]);
  return text;
}

}  // namespace

std::optional<std::size_t> Comparison::place_of(const std::string& path) const {
  const auto found = std::ranges::find(vary, path, &PathValues::path);
  if (found == vary.end()) return std::nullopt;
  return static_cast<std::size_t>(found - vary.begin());
}

std::string Comparison::label(const Member& member) const {
  return words(*this, member, std::nullopt);
}

std::string Comparison::label_without_refinement(const Member& member) const {
  return words(*this, member, refinement);
}

Comparison comparison_of(const std::string& name, const ComparisonSection& section) {
  Comparison comparison{.name = name, .vary = section.vary, .expect = section.expect};
  const std::size_t count = number_of_members(section.vary);
  for (std::size_t k = 0; k < count; ++k)
    comparison.members.push_back(member_of(section.vary, k, count));
  for (const char* key : refinement_keys)
    if (const auto place = comparison.place_of(key); place && !comparison.refinement)
      comparison.refinement = place;
  return comparison;
}

Document document_of(const Document& base, const Comparison& comparison, const Member& member) {
  Document document = base;
  for (const std::size_t place : outer_keys_first(comparison.vary)) {
    const auto& [path, values] = comparison.vary[place];
    const auto number = std::ranges::find(values, member.values[place]) - values.begin();
    const Value& value =
        base.find({"compare", "vary", path})->list[static_cast<std::size_t>(number)];
    document.set(keys_of(path), value, value.origin);
  }
  return document;
}

std::string comparison_yaml(const Document& base, const std::string& resolved_scenario) {
  Document written = base;
  written.set("version=" + std::string(version));
  Value root = written.root();
  const Value resolved = Document::parsed(resolved_scenario, {});
  replace_short_forms(root, &resolved);
  return block_text(root);
}

std::vector<std::string> assignments_of(const Comparison& comparison, const Member& member) {
  std::vector<std::string> assignments;
  for (const std::size_t place : outer_keys_first(comparison.vary))
    assignments.push_back(comparison.vary[place].path + "=" + member.values[place]);
  return assignments;
}

double spacing_along(const std::string& path, const Scenario& scenario) {
  if (path == "time.step") return *scenario.time.step;
  return std::pow(static_cast<double>(*scenario.particles.count),
                  -1 / static_cast<double>(scenario.dimension));
}

}  // namespace mote
