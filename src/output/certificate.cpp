#include "mote/output/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace mote {

namespace {

/// Length of a vector whose components are given one by one; no square of a single one overflows.
template <class Component>
double length(std::size_t components, Component component) {
  if (components == 1) return std::abs(component(0));
  double sum = 0;
  for (std::size_t c = 0; c < components; ++c) sum += component(c) * component(c);
  return std::sqrt(sum);
}

}  // namespace

ErrorNorms error_norms(const std::string& field, std::span<const double> values,
                       std::span<const double> reference, int components) {
  ErrorNorms error{.field = field};
  double l1 = 0, l2 = 0, max = 0;
  const auto width = static_cast<std::size_t>(components);
  for (std::size_t i = 0; i < values.size(); i += width) {
    const double r = length(width, [&](std::size_t c) { return reference[i + c]; });
    if (std::isnan(r)) continue;
    const double e = length(width, [&](std::size_t c) { return values[i + c] - reference[i + c]; });
    error.l1 += e;
    error.l2 += e * e;
    error.max = std::max(error.max, e);
    l1 += r;
    l2 += r * r;
    max = std::max(max, r);
    ++error.compared;
  }
  error.l2 = std::sqrt(error.l2);
  if (max > 0) {
    error.l1 /= l1;
    error.l2 /= std::sqrt(l2);
    error.max /= max;
  }
  return error;
}

std::vector<Drift> drifts(const std::vector<Conserved>& start, const std::vector<Conserved>& end) {
  std::vector<Drift> result;
  for (std::size_t q = 0; q < start.size(); ++q) {
    const double scale = std::max(start[q].scale, end[q].scale);
    const double moved = end[q].value - start[q].value;
    result.push_back(
        {start[q].name, start[q].value, end[q].value, scale > 0 ? moved / scale : moved});
  }
  return result;
}

bool Certificate::passed() const {
  return !failure && std::ranges::all_of(checks, &CheckResult::passed);
}

std::string summary_json(const Certificate& c) {
  using Json = nlohmann::ordered_json;
  const auto rate = [&](double work) { return c.wall_seconds > 0 ? work / c.wall_seconds : 0.0; };
  Json json = {{"name", c.name},
               {"version", c.version},
               {"dimension", c.dimension},
               {"particles", c.particles},
               {"model", c.model},
               {"operator", c.differential_operator},
               {"integrator", c.integrator},
               {"units", c.units},
               {"threads", c.threads},
               {"steps", c.steps},
               {"time", c.time},
               {"wall_seconds", c.wall_seconds},
               {"particle_updates_per_second",
                rate(static_cast<double>(c.particles) * static_cast<double>(c.steps_timed))},
               {"pairs_per_second", rate(static_cast<double>(c.pair_work.pairs))},
               {"evaluations", c.pair_work.evaluations},
               {"mean_neighbours", c.pair_work.mean_neighbours},
               {"against", c.against},
               {"errors", Json::object()},
               {"conservation", Json::object()},
               {"checks", Json::array()},
               {"remarks", c.remarks},
               {"warnings", c.warnings},
               {"passed", c.passed()}};
  if (c.bytes_per_particle > 0) json["bytes_per_particle"] = c.bytes_per_particle;
  for (const ErrorNorms& e : c.errors)
    json["errors"][e.field] = {
        {"l1", e.l1}, {"l2", e.l2}, {"max", e.max}, {"compared", e.compared}};
  for (const Drift& d : c.conservation)
    json["conservation"][d.quantity] = {{"start", d.start}, {"end", d.end}, {"drift", d.drift}};
  for (const CheckResult& check : c.checks)
    json["checks"].push_back({{"name", check.name},
                              {"value", check.value},
                              {"limit", check.limit},
                              {"passed", check.passed()}});
  if (c.failure) json["failure"] = *c.failure;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mote
