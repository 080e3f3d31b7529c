#include "mote/scenario/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "mote/scenario/check_space.hpp"
#include "mote/scenario/folder_name.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/reader.hpp"
#include "mote/scenario/version.hpp"
#include "mote/scenario/writer.hpp"

namespace mote {
namespace {

/// The corners of the domain, which a file may leave out if the model has no need of it.
void check_domain(const Scenario& scenario, const Document& document) {
  const auto refuse = [&](const std::string& key, const std::string& message) {
    throw LocatedError(document.locate(key), message);
  };
  const auto& [lower, upper] = std::tie(scenario.domain.lower, scenario.domain.upper);
  if (!scenario.model->needs_domain() && lower.empty() && upper.empty()) {
    if (!scenario.probes.empty()) refuse("probes", "probes need a 'domain' to lie in");
    return;
  }
  const auto dimension = static_cast<std::size_t>(scenario.dimension);
  for (const char* corner : {"lower", "upper"}) {
    const auto& values = corner[0] == 'l' ? lower : upper;
    if (values.size() != dimension)
      refuse(std::string("domain.") + corner,
             fmt::format("'{}' needs {} number{}, one a dimension, and has {}", corner, dimension,
                         dimension == 1 ? "" : "s", values.size()));
  }
  for (std::size_t d = 0; d < dimension; ++d)
    if (!(upper[d] > lower[d]))
      refuse("domain.upper",
             fmt::format("the upper corner {} must lie above the lower {}", upper[d], lower[d]));
  for (std::size_t d = 0; d < dimension; ++d)
    if (!std::isfinite(upper[d] - lower[d]))
      refuse("domain.upper", "the domain from lower to upper is wider than numbers can tell");
}

/// Rules that no single key can state.
void check_together(const Scenario& scenario, const Document& document) {
  const auto refuse = [&](const std::string& key, const std::string& message) {
    throw LocatedError(document.locate(key), message);
  };
  const std::string problem = folder_name_problem(scenario.name);
  if (!problem.empty()) refuse("name", problem);
  const auto dimension = static_cast<std::size_t>(scenario.dimension);
  check_domain(scenario, document);
  if (scenario.differential_operator.is_named() && !scenario.differential_operator.made)
    refuse("operator", fmt::format("the operator {} does not exist in {} dimensions",
                                   scenario.differential_operator.name(), scenario.dimension));
  if (!scenario.probes.empty() && scenario.model->lives_on_a_line())
    refuse("probes",
           fmt::format("probes look into flows in space, and the model {} lives on a line",
                       scenario.model_type));
  check_history_checks(scenario.check.history, scenario.time.end, scenario.constants_by_name(),
                       document);
  check_probes(scenario.probes, {dimension, scenario.domain.lower, scenario.domain.upper},
               document);
  const double steps = scenario.time.end / scenario.time.step.value_or(scenario.time.end);
  if (!(steps < 1e12))
    refuse("time.step", fmt::format("{:.3g} steps of {} to the end {} are more than 1e12", steps,
                                    *scenario.time.step, scenario.time.end));
  if (scenario.output.every.value_or(scenario.time.end) * 1e6 < scenario.time.end)
    refuse("output.every", fmt::format("a snapshot every {} makes more than a million of them",
                                       *scenario.output.every));
}

/// Models that make their own steps leave nothing to an integrator.
void check_integrator(const Scenario& scenario, const Document& document) {
  if (!scenario.model->steps_itself()) return;
  for (const std::string key : {"integrator", "tolerance", "longest_step"})
    if (document.find({"time", key}) != nullptr)
      throw LocatedError(
          document.locate("time." + key),
          fmt::format("the model {} makes its own steps, and has no integrator{}",
                      scenario.model_type, key == "integrator" ? "" : " with '" + key + "'"),
          "time." + key);
}

void fill_defaults_on_a_line(Scenario& scenario) {
  if (scenario.output.history == 0)
    scenario.output.history = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(*scenario.output.every / *scenario.time.step / 10));
  if (scenario.particles.layout.empty()) scenario.particles.layout = "regular";
  if (!scenario.domain.boundary) scenario.domain.boundary = LineEnds::zero_gradient;
  if (!scenario.domain.extension)
    scenario.domain.extension = static_cast<std::int64_t>(
        std::ceil(scenario.differential_operator.made->neighbour_rule().reach()));
}

void fill_defaults_in_space(Scenario& scenario) {
  auto& particles = scenario.particles;
  if (particles.layout.empty()) particles.layout = "lattice";
  if (particles.layout == "jittered" && !particles.jitter) particles.jitter = 0.2;
  const bool step_is_all =
      (scenario.time.step || scenario.time.tolerance) && scenario.model->step_suffices();
  if (!scenario.time.courant && !step_is_all) scenario.time.courant = 0.25;
}

/// What the defaults depend on is known only now.
void fill_defaults(Scenario& scenario, const Catalogue& catalogue) {
  auto& time = scenario.time;
  if (time.integrator.empty() && !scenario.model->steps_itself())
    time.integrator = "velocity_verlet";
  if (!time.tolerance && !time.integrator.empty())
    time.tolerance = entry_named(catalogue.integrators, time.integrator).default_tolerance;
  auto& output = scenario.output;
  if (!output.every) output.every = scenario.time.end / 10;
  if (*output.every > scenario.time.end) output.every = scenario.time.end;
  if (scenario.model->lives_on_a_line())
    fill_defaults_on_a_line(scenario);
  else
    fill_defaults_in_space(scenario);
}

enum class Record { without, with };

std::string text_of(Scenario& scenario, const Catalogue& catalogue, Record record) {
  return yaml_of([&](Description& d) {
    describe(d, scenario, catalogue);
    if (record == Record::without) return;
    if (!scenario.compare.empty()) describe_comparison(d, scenario.compare);
    describe_record(d, scenario);
  });
}

}  // namespace

bool Scenario::Checks::has_limits() const {
  const auto has_limit = [](const auto& entry) { return entry.second.has_value(); };
  return std::ranges::any_of(fields, has_limit) || std::ranges::any_of(drifts, has_limit);
}

const Scenario::Checks& Scenario::Check::of(Frame frame) const {
  return frame == Frame::eulerian && eulerian.has_limits() ? eulerian : lagrangian;
}

Triple Scenario::periods() const {
  Triple periods{};
  for (const std::string& axis : domain.periodic) {
    const auto d = static_cast<std::size_t>(axis.front() - 'x');
    periods[d] = domain.upper[d] - domain.lower[d];
  }
  return periods;
}

Scenario read_scenario(const Document& document, const Catalogue& catalogue) {
  Scenario scenario;
  Reader reader(document);
  describe(reader, scenario, catalogue);
  describe_comparison(reader, scenario.compare);
  describe_record(reader, scenario);
  reader.finish();
  check_line_or_space(scenario, document);
  check_together(scenario, document);
  check_integrator(scenario, document);
  check_comparison(scenario.compare, document);
  fill_defaults(scenario, catalogue);
  return scenario;
}

std::string resolved_yaml(Scenario& scenario, const Catalogue& catalogue) {
  scenario.written_by = version;
  return text_of(scenario, catalogue, Record::with);
}

std::string fingerprint(Scenario& scenario, const Catalogue& catalogue) {
  // FNV-1a, 64 bits: tells files apart, protects against nothing.
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const unsigned char c : text_of(scenario, catalogue, Record::without))
    hash = (hash ^ c) * 0x100000001b3u;
  return fmt::format("{:016x}", hash);
}

}  // namespace mote
