#include "mote/scenario/operator_choice.hpp"

#include <algorithm>

namespace mote {
namespace {

/// The families of operators as choices.
Choices families(const Catalogue& catalogue) {
  Choices choices;
  for (const OperatorEntry& entry : catalogue.operators)
    if (std::ranges::find(choices, entry.family, &Choice::name) == choices.end())
      choices.push_back(
          {entry.family, entry.member.empty() ? entry.summary : "on a " + entry.distinction});
  return choices;
}

Choices members_of(const Catalogue& catalogue, const std::string& family) {
  Choices choices;
  for (const OperatorEntry& entry : catalogue.operators)
    if (entry.family == family && !entry.member.empty())
      choices.push_back({entry.member, entry.summary});
  return choices;
}

/// The key by which a family's members are told apart; empty for a family of one.
std::string distinction_of(const Catalogue& catalogue, const std::string& family) {
  const auto entry = std::ranges::find(catalogue.operators, family, &OperatorEntry::family);
  return entry == catalogue.operators.end() ? "" : entry->distinction;
}

}  // namespace

void describe_operator(Description& d, OperatorChoice& choice, const Catalogue& catalogue,
                       std::int64_t dimension, bool required) {
  const auto describe_member = [&](const std::string& family, const std::string& member) {
    if (!choice.made || choice.family != family || choice.member != member)
      choice.made = catalogue.make_operator(family, member, std::max<std::int64_t>(1, dimension));
    choice.family = family;
    choice.member = member;
    if (choice.made) choice.made->describe(d);
  };
  d.variant({"family", "what the weights of neighbours come from", required}, choice.family,
            families(catalogue), [&](const std::string& family) {
              if (family.empty()) return;
              const std::string key = distinction_of(catalogue, family);
              if (key.empty()) return describe_member(family, "");
              d.variant({key, "which of the family", true}, choice.member,
                        members_of(catalogue, family),
                        [&](const std::string& member) { describe_member(family, member); });
            });
}

}  // namespace mote
