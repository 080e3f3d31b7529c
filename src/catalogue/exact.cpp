#include "mote/catalogue/exact.hpp"

#include "mote/catalogue/refined.hpp"
#include "mote/exact/gravitating_sheets.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

std::vector<double> copy(std::span<const double> values) { return {values.begin(), values.end()}; }

std::unique_ptr<ExactSolution> sheets_from(const ExactSetup& setup) {
  const auto& [initial, parameters, start, refined] = setup;
  if (!parameters.contains("gravity") || !initial.has("length_rate"))
    throw InputError("check.against", "gravitating_sheets solves the model pressureless_gas alone");
  if (parameters.at("viscosity") != 0)
    throw InputError("check.against", "gravitating_sheets has no viscosity, this gas has");
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

}  // namespace

std::vector<ExactEntry> exact_entries() {
  return {{choice_of<GravitatingSheets>(), {"position", "velocity", "density"}, sheets_from},
          {choice_of<Refined>(), {"position", "velocity", "density"}, refined_from}};
}

}  // namespace mote
