#include <cmath>

#include "mote/app/simulation.hpp"
#include "mote/scenario/version.hpp"

namespace mote {
namespace {

void compare_with_exact(const Simulation& simulation, double time, Certificate& certificate) {
  const Cloud& cloud = simulation.model().cloud();
  const bool lagrangian = simulation.model().frame() == Frame::lagrangian;
  const Table reference = lagrangian ? simulation.exact()->of_particles(time)
                                     : simulation.exact()->at_places(cloud.position(), time);
  for (const Column& column : reference)
    certificate.errors.push_back(
        error_norms(column.name, cloud.values(column.name), column.values));
}

/// Sets the numbers of the certificate against the limits of the scenario.
void add_checks(const Scenario::Checks& checks, Certificate& certificate) {
  for (const auto& [field, limit] : checks.fields)
    for (const ErrorNorms& error : certificate.errors)
      if (limit && error.field == field)
        certificate.checks.push_back({field + " relative L2 error", error.l2, *limit});
  for (const auto& [quantity, limit] : checks.drifts)
    for (const Drift& drift : certificate.conservation)
      if (limit && drift.quantity == quantity)
        certificate.checks.push_back({quantity + " drift", std::abs(drift.drift), *limit});
}

Certificate certificate_without_results(const Simulation& simulation, const Moment& moment) {
  const Scenario& scenario = simulation.scenario();
  Certificate certificate{.name = scenario.name,
                          .version = std::string(version),
                          .units = scenario.units,
                          .differential_operator = scenario.differential_operator.name(),
                          .integrator = scenario.time.integrator,
                          .model = scenario.model_type,
                          .against = scenario.check.against,
                          .dimension = scenario.dimension,
                          .particles = simulation.model().cloud().count(),
                          .steps = moment.step,
                          .time = moment.time};
  certificate.pair_work = simulation.model().pair_work();
  certificate.warnings = simulation.warnings();
  for (const std::string& warning : simulation.model().warnings())
    certificate.warnings.push_back(scenario.name + ": warning: " + warning);
  return certificate;
}

}  // namespace

Certificate certificate_of(const Simulation& simulation, const Moment& moment) {
  const Model& model = simulation.model();
  Certificate certificate = certificate_without_results(simulation, moment);
  certificate.remarks = model.remarks();
  certificate.conservation = drifts(simulation.conserved_at_start(), model.conserved());
  if (simulation.exact() != nullptr) {
    compare_with_exact(simulation, moment.time, certificate);
    certificate.remarks.push_back(simulation.exact()->statement() + ".");
  }
  add_checks(simulation.scenario().check.of(model.frame()), certificate);
  return certificate;
}

Certificate failed_certificate(const Simulation& simulation, const Moment& moment,
                               const std::string& failure) {
  Certificate certificate = certificate_without_results(simulation, moment);
  certificate.failure = failure;
  return certificate;
}

}  // namespace mote
