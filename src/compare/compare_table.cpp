#include "mote/compare/compare_table.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mote/output/files.hpp"

namespace mote {
namespace {

using Json = nlohmann::ordered_json;

/// A number of a certificate; one that is not finite stands there as null.
double number(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : std::nan("");
}

Certificate certificate_from(const Json& json) {
  Certificate certificate;
  certificate.particles = json.at("particles");
  certificate.steps = json.at("steps");
  certificate.time = number(json, "time");
  certificate.against = json.at("against");
  certificate.wall_seconds = number(json, "wall_seconds");
  certificate.pair_work.evaluations = json.at("evaluations");
  for (const auto& [field, error] : json.at("errors").items())
    certificate.errors.push_back(
        {field, number(error, "l1"), number(error, "l2"), number(error, "max")});
  for (const auto& [quantity, drift] : json.at("conservation").items())
    certificate.conservation.push_back(
        {quantity, number(drift, "start"), number(drift, "end"), number(drift, "drift")});
  if (json.contains("failure")) certificate.failure = json.at("failure");
  return certificate;
}

/// The names of a list in the certificates, each once, in the order in which they come up.
template <class List, class Item>
std::vector<std::string> names_in(const std::vector<Row>& rows, List Certificate::*list,
                                  std::string Item::*name) {
  std::vector<std::string> names;
  for (const Row& row : rows) {
    if (!row.run) continue;
    for (const Item& item : *row.run.*list)
      if (std::ranges::find(names, item.*name) == names.end()) names.push_back(item.*name);
  }
  return names;
}

}  // namespace

const std::string& Row::failure() const { return broke_down() ? *run->failure : problem; }

const ErrorNorms* Row::error(const std::string& field) const {
  if (!run) return nullptr;
  const auto found = std::ranges::find(run->errors, field, &ErrorNorms::field);
  return found == run->errors.end() ? nullptr : &*found;
}

std::optional<double> Row::drift(const std::string& quantity) const {
  if (!run) return std::nullopt;
  const auto found = std::ranges::find(run->conservation, quantity, &Drift::quantity);
  return found == run->conservation.end() ? std::nullopt : std::optional(found->drift);
}

const Norm& norm_named(const std::string& name) {
  return *std::ranges::find_if(norms, [&](const Norm& norm) { return name == norm.name; });
}

Row row_of(std::size_t member, const std::filesystem::path& folder, const std::string& problem) {
  Row row{.member = member, .problem = problem};
  if (!problem.empty()) return row;
  try {
    const Json json = Json::parse(read_file(folder / "summary.json"));
    row.run = certificate_from(json);
    row.passed = json.at("passed");
    row.is_checked = !json.at("checks").empty();
    for (const Json& check : json.at("checks"))
      if (!check.at("passed")) row.failed_checks.push_back(check.at("name"));
    row.updates_per_second = number(json, "particle_updates_per_second");
  } catch (const std::exception&) {
    row = {.member = member};
    row.problem = "the run left no summary.json that can be read";
  }
  return row;
}

void CompareTable::add(Row row) {
  const auto place = std::ranges::upper_bound(rows_, row.member, {}, &Row::member);
  rows_.insert(place, std::move(row));
}

const Row* CompareTable::of(std::size_t member) const {
  const auto found = std::ranges::find(rows_, member, &Row::member);
  return found == rows_.end() ? nullptr : &*found;
}

std::vector<std::string> CompareTable::fields() const {
  return names_in(rows_, &Certificate::errors, &ErrorNorms::field);
}

std::vector<std::string> CompareTable::quantities() const {
  return names_in(rows_, &Certificate::conservation, &Drift::quantity);
}

bool CompareTable::counts_evaluations() const {
  return std::ranges::any_of(
      rows_, [](const Row& row) { return row.run && row.run->pair_work.evaluations > 0; });
}

const Row* CompareTable::coarser(const Row& row) const {
  const auto& members = comparison_->members;
  if (!comparison_->refinement) return nullptr;
  const Member& fine = members[row.member];
  const std::string family = comparison_->label_without_refinement(fine);
  std::optional<std::size_t> next;
  for (std::size_t k = 0; k < members.size(); ++k)
    if (members[k].spacing > fine.spacing &&
        (!next || members[k].spacing < members[*next].spacing) &&
        comparison_->label_without_refinement(members[k]) == family)
      next = k;
  return next ? of(*next) : nullptr;
}

std::optional<double> CompareTable::order(const Row& row, const std::string& field,
                                          const Norm& norm) const {
  const Row* before = coarser(row);
  const ErrorNorms* fine = row.error(field);
  const ErrorNorms* coarse = before != nullptr ? before->error(field) : nullptr;
  if (fine == nullptr || coarse == nullptr) return std::nullopt;
  const auto& members = comparison_->members;
  const double order = std::log(coarse->*norm.value / (fine->*norm.value)) /
                       std::log(members[before->member].spacing / members[row.member].spacing);
  return std::isfinite(order) ? std::optional(order) : std::nullopt;
}

}  // namespace mote
