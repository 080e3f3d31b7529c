#include "mote/app/line_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

std::unique_ptr<DifferentialOperator<1>> on_a_line(std::unique_ptr<AnyOperator> any) {
  return std::unique_ptr<DifferentialOperator<1>>(
      dynamic_cast<DifferentialOperator<1>*>(any.release()));
}

}  // namespace

InitialValue initial_value(const Scenario& scenario) {
  auto expressions = std::make_shared<std::map<std::string, Expression, std::less<>>>();
  for (const auto& [field, text] : scenario.initial)
    expressions->emplace(field, Expression(text, scenario.constants_by_name()));
  return [expressions](std::string_view field, double x) {
    const double value = expressions->find(field)->second({.x = x});
    if (!std::isfinite(value))
      throw InputError("initial." + std::string(field),
                       fmt::format("'{}' is {} at x = {:.6g}", field,
                                   std::isnan(value) ? "not a number" : fmt::to_string(value), x));
    return value;
  };
}

LineStart line_start(const Scenario& scenario, const Catalogue& catalogue) {
  LineStart setup;
  setup.lower = scenario.domain.lower[0];
  setup.upper = scenario.domain.upper[0];
  setup.ends = *scenario.domain.boundary;
  setup.extension = *scenario.domain.extension;
  setup.initial = initial_value(scenario);
  const auto& particles = scenario.particles;
  const auto& layout = entry_named(catalogue.layouts, particles.layout);
  setup.cells = layout.cells(setup.lower, setup.upper, static_cast<Index>(*particles.count),
                             static_cast<std::uint64_t>(particles.seed));
  const double resolution = 16 * std::numeric_limits<double>::epsilon() *
                            std::max(std::abs(setup.lower), std::abs(setup.upper));
  if (std::ranges::min(setup.cells.length) <= resolution)
    throw InputError("particles.count", fmt::format("{} particles between {} and {} lie closer "
                                                    "than numbers can tell",
                                                    *particles.count, setup.lower, setup.upper));
  return setup;
}

LineStart divided(LineStart start, int pieces) {
  Cells fine;
  for (std::size_t i = 0; i < start.cells.centre.size(); ++i)
    for (int k = 0; k < pieces; ++k) {
      const double part = (k + 0.5) / pieces - 0.5;
      fine.centre.push_back(start.cells.centre[i] + part * start.cells.length[i]);
      fine.length.push_back(start.cells.length[i] / pieces);
    }
  start.cells = std::move(fine);
  return start;
}

LineSetup line_setup(Scenario& scenario, const Catalogue& catalogue) {
  LineSetup setup{line_start(scenario, catalogue)};
  setup.differential_operator = on_a_line(std::move(scenario.differential_operator.made));
  return setup;
}

std::unique_ptr<Model> finely_divided(const Scenario& scenario, const Catalogue& catalogue) {
  LineStart start = line_start(scenario, catalogue);
  const int pieces = std::clamp(1'000'000 / static_cast<int>(start.cells.centre.size()), 1, 50);
  LineSetup setup{divided(std::move(start), pieces)};
  setup.differential_operator = on_a_line(catalogue.make_operator(
      scenario.differential_operator.family, scenario.differential_operator.member, 1));
  return scenario.model->make(std::move(setup));
}

std::string missing_neighbours(const Scenario& scenario) {
  const std::string name = scenario.differential_operator.name();
  const std::int64_t extension = *scenario.domain.extension;
  const NeighbourRule rule = scenario.differential_operator.made->neighbour_rule();
  if (rule.adjacent > extension)
    throw InputError("domain.extension",
                     fmt::format("{} needs {} cell{} beyond each end, and 'extension' is {}", name,
                                 rule.adjacent, rule.adjacent == 1 ? "" : "s", extension));
  if (static_cast<double>(extension) >= std::floor(rule.reach())) return "";
  return fmt::format(
      "the region goes on for {} cells beyond its ends, but the operator reaches {:.3g}: "
      "derivatives near the ends miss neighbours",
      extension, rule.reach());
}

/// Fields with their rates and work arrays, and the neighbours, whose lists keep as much room again
/// for particles that come to have more.
double memory_on_a_line(const Scenario& scenario) {
  constexpr double fields = 400;
  const auto count = static_cast<double>(*scenario.particles.count);
  const double reach = scenario.differential_operator.made->neighbour_rule().reach();
  return count * (fields + 2 * std::min(2 * reach, count) * static_cast<double>(sizeof(Index)));
}

}  // namespace mote
