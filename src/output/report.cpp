#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "mote/output/certificate.hpp"

namespace mote {
namespace {

using Out = std::back_insert_iterator<std::string>;

std::string verdict(const Certificate& c) {
  if (c.failure) return "**Failed: the numerics broke down.** " + *c.failure;
  if (c.checks.empty()) return "**Ran to the end.** The scenario states no check.";
  return c.passed() ? "**Passed: every check holds.**" : "**A check failed.**";
}

/// The same number; a NaN without a sign, which has no meaning.
double plain(double number) {
  return std::isnan(number) ? std::numeric_limits<double>::quiet_NaN() : number;
}

struct CheckWords {
  std::string value, limit;
};

/// With three digits, or as many more as tell the value from its limit.
CheckWords words_of(const CheckResult& check) {
  CheckWords words;
  for (int digits = 3; words.value == words.limit && digits <= 17; ++digits) {
    words = {fmt::format("{:.{}g}", plain(check.value), digits),
             fmt::format("{:.{}g}", check.limit, digits)};
    if (check.value == check.limit) break;
  }
  words.limit.insert(0, check.sense == CheckResult::Sense::at_most ? "at most " : "at least ");
  return words;
}

void add_errors(Out out, const Certificate& c) {
  if (c.errors.empty()) return;
  fmt::format_to(out,
                 "\n## Errors at t = {:.6g} against `{}`\n\nRelative to the reference's own norm."
                 "\n\n| field | L1 | L2 | max | points compared |\n|---|---|---|---|---|\n",
                 c.time, c.against);
  for (const ErrorNorms& e : c.errors)
    fmt::format_to(out, "| {} | {:.3g} | {:.3g} | {:.3g} | {} of {} |\n", e.field, plain(e.l1),
                   plain(e.l2), plain(e.max), e.compared, c.particles);
}

void add_conservation(Out out, const Certificate& c) {
  if (c.conservation.empty()) return;
  fmt::format_to(out,
                 "\n## Conservation\n\n| quantity | start | end | relative drift |\n"
                 "|---|---|---|---|\n");
  for (const Drift& d : c.conservation)
    fmt::format_to(out, "| {} | {:.9g} | {:.9g} | {:.2e} |\n", d.quantity, plain(d.start),
                   plain(d.end), plain(d.drift));
}

void add_cost(Out out, const Certificate& c) {
  fmt::format_to(out,
                 "\n## Cost\n\n{} particles, {} steps to t = {:.6g}; {} steps in {:.3g} s on {} "
                 "thread{}: {:.3g} particle updates a second.\n",
                 c.particles, c.steps, c.time, c.steps_timed, c.wall_seconds, c.threads,
                 c.threads == 1 ? "" : "s",
                 c.wall_seconds > 0 ? static_cast<double>(c.particles) *
                                          static_cast<double>(c.steps_timed) / c.wall_seconds
                                    : 0.0);
  if (c.bytes_per_particle > 0)
    fmt::format_to(out, "At most {:.0f} bytes of memory a particle.\n", c.bytes_per_particle);
  if (c.pair_work.mean_neighbours > 0)
    fmt::format_to(out, "{:.1f} neighbours a particle, gone through {} times.\n",
                   c.pair_work.mean_neighbours, c.pair_work.evaluations);
  else if (c.pair_work.evaluations > 0)
    fmt::format_to(out, "Sums over all were formed {} times.\n", c.pair_work.evaluations);
}

}  // namespace

std::string checks_markdown(const std::vector<CheckResult>& checks) {
  if (checks.empty()) return "";
  std::string text = "\n## Checks\n\n| check | value | limit | |\n|---|---|---|---|\n";
  for (const CheckResult& check : checks) {
    const auto [value, limit] = words_of(check);
    fmt::format_to(std::back_inserter(text), "| {} | {} | {} | {} |\n", check.name, value, limit,
                   check.passed() ? "passed" : "**failed**");
  }
  return text;
}

std::string checks_text(const std::vector<CheckResult>& checks) {
  std::size_t width = 28;
  for (const CheckResult& check : checks) width = std::max(width, check.name.size());
  std::string text;
  for (const CheckResult& check : checks) {
    const auto [value, limit] = words_of(check);
    fmt::format_to(std::back_inserter(text), "  {:<{}} {:<10} {:<18} {}\n", check.name, width,
                   value, limit, check.passed() ? "passed" : "FAILED");
  }
  return text;
}

std::string report_markdown(const Certificate& c, const std::string& picture) {
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(out, "# {}\n\n{}\n", c.name, verdict(c));
  if (!picture.empty()) fmt::format_to(out, "\n![fields at the end]({})\n", picture);
  text += checks_markdown(c.checks);
  add_errors(out, c);
  add_conservation(out, c);
  fmt::format_to(out, "\n## Method\n\nModel `{}`, operator `{}`, integrator `{}`; units: {}.\n",
                 c.model, c.differential_operator, c.integrator, c.units);
  for (const auto& remark : c.remarks) fmt::format_to(out, "{}\n", remark);
  if (!c.warnings.empty()) fmt::format_to(out, "\n## Warnings\n\n");
  for (const auto& warning : c.warnings) fmt::format_to(out, "- {}\n", warning);
  add_cost(out, c);
  fmt::format_to(out, "\nmote {}; the scenario with every default is in `run.yaml`.\n", c.version);
  return text;
}

}  // namespace mote
