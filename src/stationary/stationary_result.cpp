#include "mote/stationary/stationary_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

constexpr int points = 801;

std::string numbered(const std::string& name, int state) {
  return fmt::format("{}_{}", name, state + 1);
}

Table energy_table(const StationaryStates& states, const std::optional<ExactStates>& exact) {
  Table table{{"state", {}}, {"energy", {}}};
  if (exact) table.insert(table.end(), {{"exact", {}}, {"relative_error", {}}});
  for (int state = 0; state < states.count(); ++state) {
    const double energy = states.energies()[state];
    table[0].values.push_back(state + 1);
    table[1].values.push_back(energy);
    if (!exact) continue;
    const double expected = exact->energy(state);
    table[2].values.push_back(expected);
    table[3].values.push_back((energy - expected) / std::abs(expected));
  }
  return table;
}

void refuse_numbers_that_are_not_finite(const Table& table) {
  for (const Column& column : table)
    if (!std::ranges::all_of(column.values, [](double value) { return std::isfinite(value); }))
      throw NumericalFailure(
          fmt::format("'{}' of a state is not finite", column.name), {},
          "the ends of the domain are so far apart, or so close, that exact energies are too small "
          "or too large for a number");
}

std::string verdict(const Certificate& certificate) {
  if (certificate.checks.empty()) return "**Solved.** The scenario states no check.";
  return certificate.passed() ? "**Passed: every check holds.**" : "**A check failed.**";
}

}  // namespace

StationaryResult::StationaryResult(const StationaryFile& file)
    : file_(file),
      problem_(problem_of(file)),
      states_(problem_, static_cast<int>(file.states)),
      exact_(exact_states_of(file)),
      energies_(energy_table(states_, exact_)) {
  refuse_numbers_that_are_not_finite(energies_);
}

Table StationaryResult::wave_functions() const {
  Table table{{"x", {}}};
  const double from = problem_.lower - tail_length(problem_.decay_below);
  const double to = problem_.upper + tail_length(problem_.decay_above);
  for (int k = 0; k < points; ++k) table[0].values.push_back(from + (to - from) * k / (points - 1));
  const auto add = [&](const std::string& name, int state, const auto& wave_function) {
    Column column{numbered(name, state), {}};
    for (const double x : table[0].values) column.values.push_back(wave_function(state, x));
    table.push_back(std::move(column));
  };
  for (int state = 0; state < states_.count(); ++state)
    add("psi", state, [&](int n, double x) { return states_.wave_function(n, x); });
  for (int state = 0; exact_ && state < states_.count(); ++state)
    add("exact", state, exact_->wave_function);
  return table;
}

std::string StationaryResult::remark() const {
  const auto words = [](const std::optional<double>& decay) {
    return decay ? fmt::format("a tail that falls like e^(-{:.6g} x)", *decay)
                 : std::string("a wall");
  };
  return fmt::format("At the lower end there is {}, at the upper {}.", words(problem_.decay_below),
                     words(problem_.decay_above));
}

std::vector<std::string> StationaryResult::warnings() const {
  std::vector<std::string> warnings;
  const std::optional<double> limit = binding_limit(file_, problem_);
  for (int state = 0; limit && state < states_.count(); ++state)
    if (const double energy = states_.energies()[state]; energy >= *limit)
      warnings.push_back(
          fmt::format("state {} with E = {:.6g} is not bound: the potential far out is {:.6g}, and "
                      "the tail that falls there is not that of this state",
                      state + 1, energy, *limit));
  return warnings;
}

std::vector<CheckResult> StationaryResult::checks() const {
  std::vector<CheckResult> checks;
  for (std::size_t state = 0; state < file_.energy_limits.size(); ++state)
    checks.push_back({fmt::format("energy {} relative error", state + 1),
                      std::abs(energies_[3].values[state]), file_.energy_limits[state]});
  return checks;
}

std::string stationary_markdown(const Certificate& certificate, const Table& energies,
                                const std::string& picture) {
  std::string text = fmt::format("# {}\n\n{}\n", certificate.name, verdict(certificate));
  const auto out = std::back_inserter(text);
  if (!picture.empty()) fmt::format_to(out, "\n![wave functions]({})\n", picture);
  const bool has_exact = energies.size() > 2;
  fmt::format_to(out, "\n## Energies\n\n| state | energy |{}\n|---|---|{}\n",
                 has_exact ? " exact | relative error |" : "", has_exact ? "---|---|" : "");
  for (std::size_t row = 0; row < energies[0].values.size(); ++row) {
    fmt::format_to(out, "| {} | {:.12g} |", energies[0].values[row], energies[1].values[row]);
    if (has_exact)
      fmt::format_to(out, " {:.12g} | {:.2e} |", energies[2].values[row], energies[3].values[row]);
    text += '\n';
  }
  text += checks_markdown(certificate.checks);
  fmt::format_to(out,
                 "\n## Method\n\nModel `{}`, first-order ContEvol on {} nodes, in units with "
                 "hbar^2/2m = 1.\n",
                 certificate.model, certificate.particles);
  for (const auto& remark : certificate.remarks) fmt::format_to(out, "{}\n", remark);
  if (!certificate.warnings.empty()) fmt::format_to(out, "\n## Warnings\n\n");
  for (const auto& warning : certificate.warnings) fmt::format_to(out, "- {}\n", warning);
  fmt::format_to(
      out,
      "\nSolved in {:.3g} s. Wave functions are in `wave_functions.csv`.\n\nmote {}; the "
      "scenario with every default is in `run.yaml`.\n",
      certificate.wall_seconds, certificate.version);
  return text;
}

}  // namespace mote
