#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "mote/particles/failure.hpp"
#include "mote/scenario/expression.hpp"
#include "mote/stationary/stationary_file.hpp"

namespace mote {
namespace {

std::function<double(double)> compiled(const StationaryFile& file) {
  const Constants constants{file.constants.begin(), file.constants.end()};
  const auto formula = std::make_shared<Expression>(file.formula, constants);
  return [formula](double x) {
    const double value = (*formula)({.x = x});
    if (!std::isfinite(value))
      throw InputError("model.formula", fmt::format("the potential has no value at x = {:.6g}", x));
    return value;
  };
}

}  // namespace

SchroedingerProblem problem_of(const StationaryFile& file) {
  const double lower = file.lower[0], upper = file.upper[0];
  SchroedingerProblem problem{.potential = [](double) { return 0.0; },
                              .lower = lower,
                              .upper = upper,
                              .intervals = static_cast<int>(file.nodes - 1),
                              .form = WaveForm::plain,
                              .decay_below = file.decay,
                              .decay_above = file.decay};
  if (file.potential == "formula") problem.potential = compiled(file);
  if (file.potential == "harmonic_oscillator") {
    problem.potential = [](double x) { return x * x; };
    problem.decay_below = file.decay.value_or(std::abs(lower));
    problem.decay_above = file.decay.value_or(std::abs(upper));
  }
  if (file.potential == "coulomb") {
    problem.potential = [](double r) { return -2 / r; };
    problem.form = WaveForm::radial;
    problem.decay_below = {};
    problem.decay_above = file.decay.value_or(1 / upper);
  }
  return problem;
}

double tail_length(const std::optional<double>& decay) { return decay ? 5 / *decay : 0; }

std::optional<double> binding_limit(const StationaryFile& file,
                                    const SchroedingerProblem& problem) {
  if (file.potential == "harmonic_oscillator") return std::nullopt;  // every state is bound
  if (file.potential == "coulomb") return 0;
  std::optional<double> limit;
  if (problem.decay_below)
    limit = problem.potential(problem.lower - tail_length(problem.decay_below));
  if (problem.decay_above) {
    const double above = problem.potential(problem.upper + tail_length(problem.decay_above));
    limit = std::min(limit.value_or(above), above);
  }
  return limit;
}

std::optional<ExactStates> exact_states_of(const StationaryFile& file) {
  if (file.against == "nothing") return std::nullopt;
  if (file.potential == "infinite_well") return well_states(file.lower[0], file.upper[0]);
  if (file.potential == "harmonic_oscillator") return oscillator_states();
  if (file.potential == "coulomb") return coulomb_states();
  return std::nullopt;
}

}  // namespace mote
