#include "mote/catalogue/exact.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "mote/catalogue/exact_bodies.hpp"
#include "mote/catalogue/exact_flows.hpp"
#include "mote/catalogue/exact_tracers.hpp"
#include "mote/catalogue/exact_vortices.hpp"
#include "mote/catalogue/refined.hpp"
#include "mote/exact/burgers_cole_hopf.hpp"
#include "mote/exact/gravitating_sheets.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

std::vector<double> copy(std::span<const double> values) { return {values.begin(), values.end()}; }

std::unique_ptr<ExactSolution> sheets_from(const ExactSetup& setup) {
  const auto& initial = setup.initial;
  const auto& parameters = setup.parameters;
  if (!parameters.contains("gravity") || !initial.has("length_rate"))
    throw InputError("check.against", "gravitating_sheets solves the model pressureless_gas alone");
  if (parameters.at("viscosity") != 0)
    throw InputError("check.against", "gravitating_sheets has no viscosity, this gas has");
  if (parameters.at("smoothed") != 0 && parameters.at("standing") != 0)
    throw InputError("check.against",
                     "gravitating_sheets shows standing points the gas in finer cells, which start "
                     "without the smoothing");
  return std::make_unique<GravitatingSheets>(
      SheetCells{copy(initial.position()), copy(initial.values("velocity")),
                 copy(initial.values("length")), copy(initial.values("length_rate")),
                 copy(initial.values("mass")), parameters.at("lower"), parameters.at("gravity")});
}

std::unique_ptr<ExactSolution> refined_from(const ExactSetup& setup) {
  const std::unique_ptr<Model> unrefined = setup.refined(1);
  if (unrefined == nullptr)
    throw InputError("check.against", "this model has no reference on refined cells");
  return std::make_unique<Refined>(setup.refined, unrefined->cloud().count());
}

/// Walls are mirrors, and the solution on the whole line has them only if its start does.
void refuse_starts_that_walls_change(const ExactSetup& setup) {
  constexpr int samples = 1000;
  const double lower = setup.parameters.at("lower"), upper = setup.parameters.at("upper");
  double size = 0, wrong = 0;
  for (int k = 1; k <= samples; ++k)
    for (const double wall : {lower, upper}) {
      const double away = (upper - lower) * k / samples;
      const double above = setup.start("velocity", wall + away);
      const double below = setup.start("velocity", wall - away);
      size = std::max({size, std::abs(above), std::abs(below)});
      wrong = std::max(wrong, std::abs(above + below));
    }
  if (wrong > 1e-9 * size)
    throw InputError("check.against",
                     "burgers_cole_hopf is for the whole line, and stands for walls only if the "
                     "start velocity is odd about both, as a sine between its zeros is");
}

std::unique_ptr<ExactSolution> burgers_from(const ExactSetup& setup) {
  const auto& initial = setup.initial;
  const auto& parameters = setup.parameters;
  if (!parameters.contains("viscosity") || !parameters.contains("gravity") ||
      !initial.has("length"))
    throw InputError("check.against", "burgers_cole_hopf solves the model pressureless_gas alone");
  if (parameters.at("viscosity") == 0)
    throw InputError("check.against", "burgers_cole_hopf needs a viscosity, this gas has none");
  if (parameters.at("gravity") != 0)
    throw InputError("check.against", "burgers_cole_hopf has no gravity, this gas has");
  if (parameters.at("smoothed") != 0)
    throw InputError("check.against",
                     "burgers_cole_hopf starts from the density as it is given, not smoothed");
  if (parameters.at("walls") != 0) refuse_starts_that_walls_change(setup);
  const auto field = [start = setup.start](const char* name) {
    return [start, name](double x) { return start(name, x); };
  };
  try {
    return std::make_unique<BurgersColeHopf>(
        BurgersStart{field("velocity"), field("density"), copy(initial.position()),
                     parameters.at("lower"), parameters.at("upper"), parameters.at("viscosity")});
  } catch (const InputError& problem) {
    throw InputError(problem.key(), std::string(problem.what()) +
                                        ", and burgers_cole_hopf needs it on the whole line");
  } catch (const std::invalid_argument& problem) {
    throw InputError("check.against",
                     "burgers_cole_hopf has no answer: " + std::string(problem.what()));
  }
}

}  // namespace

std::vector<ExactEntry> exact_entries() {
  const std::vector<std::string> fields{"position", "velocity", "density"};
  std::vector<ExactEntry> entries{{choice_of<GravitatingSheets>(), fields, sheets_from},
                                  {choice_of<BurgersColeHopf>(), fields, burgers_from},
                                  {choice_of<Refined>(), fields, refined_from}};
  std::ranges::move(flow_entries(), std::back_inserter(entries));
  std::ranges::move(vortex_entries(), std::back_inserter(entries));
  std::ranges::move(bodies_entries(), std::back_inserter(entries));
  std::ranges::move(tracer_entries(), std::back_inserter(entries));
  return entries;
}

}  // namespace mote
