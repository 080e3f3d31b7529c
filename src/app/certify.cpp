#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>

#include "mote/app/simulation.hpp"
#include "mote/scenario/version.hpp"

namespace mote {
namespace {

/// The particles whose fields an exact solution knows: all on a line, the fluid's in space.
std::vector<Index> compared(const Model& model) {
  const auto bodies = model.bodies();
  std::vector<Index> found;
  for (Index i = 0; i < model.cloud().count(); ++i)
    if (bodies.empty() ||
        bodies[static_cast<std::size_t>(model.cloud().values("body")[i])].kind == BodyKind::fluid)
      found.push_back(i);
  return found;
}

/// The columns of a reference for a field, one a component: `f`, or `f_x`, `f_y`, ... of a vector
/// in space; none if it does not know them all.
std::vector<const Column*> columns_of(const Field& field, const Table& reference) {
  std::vector<const Column*> columns;
  for (int c = 0; c < field.components; ++c)
    for (const Column& column : reference)
      if (column.name == field.name ||
          (field.kind == FieldKind::vector && column.name == field.name + "_" + axis_names[c]))
        columns.push_back(&column);
  if (columns.size() != static_cast<std::size_t>(field.components)) columns.clear();
  return columns;
}

/// The coordinate of that image of a place which is nearest to another; a period of 0 is none.
double nearest_image(double place, double other, double period) {
  return period > 0 ? place - period * std::round((place - other) / period) : place;
}

/// The error of a field over some particles, whose reference the columns hold in the same order.
/// Places are those of the nearest images.
ErrorNorms error_of(const Field& field, const std::vector<Index>& particles,
                    const std::vector<const Column*>& columns, const Triple& periods) {
  const bool is_place = field.name == "position";
  std::vector<double> values, reference;
  for (std::size_t row = 0; row < particles.size(); ++row)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto at = static_cast<std::size_t>(particles[row]) * columns.size() + c;
      const double exact = columns[c]->values[row];
      values.push_back(field.values[at]);
      reference.push_back(is_place ? nearest_image(exact, values.back(), periods[c]) : exact);
    }
  return error_norms(field.name, values, reference, field.components);
}

std::vector<double> places_of(const Cloud& cloud, const std::vector<Index>& particles) {
  std::vector<double> places;
  for (const Index i : particles)
    for (int c = 0; c < cloud.dimension(); ++c)
      places.push_back(cloud.position()[static_cast<std::size_t>(i) * cloud.dimension() + c]);
  return places;
}

/// The exact fields of these particles: moving points are compared with the solution at the same
/// points of the material if it knows them, all others with the one at their places.
Table reference_of(const Simulation& simulation, const std::vector<Index>& particles, double time) {
  const Model& model = simulation.model();
  if (model.frame() == Frame::lagrangian && simulation.exact()->knows_particles())
    return simulation.exact()->of_particles(time);
  return simulation.exact()->at_places(places_of(model.cloud(), particles), time);
}

/// The most memory that this process had, in bytes a particle.
double peak_bytes_per_particle(const Model& model) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss) / static_cast<double>(model.cloud().count());
}

/// The error of a field in the norm that the scenario's limits are meant in.
CheckResult error_check(const ErrorNorms& error, const std::string& norm, double limit) {
  const char* words = norm == "l1" ? "L1" : norm == "l2" ? "L2" : "largest";
  return {fmt::format("{} relative {} error", error.field, words), error.in_norm(norm), limit};
}

/// Sets the numbers of the certificate against the limits of the scenario.
void add_checks(const Scenario::Checks& checks, const std::string& norm, Certificate& certificate) {
  for (const auto& [field, limit] : checks.fields)
    for (const ErrorNorms& error : certificate.errors)
      if (limit && error.field == field)
        certificate.checks.push_back(error_check(error, norm, *limit));
  for (const auto& [quantity, limit] : checks.drifts)
    for (const Drift& drift : certificate.conservation)
      if (limit && drift.quantity == quantity)
        certificate.checks.push_back({quantity + " drift", std::abs(drift.drift), *limit});
}

Certificate certificate_without_results(const Simulation& simulation, const Moment& moment) {
  const Scenario& scenario = simulation.scenario();
  Certificate certificate{
      .name = scenario.name,
      .version = std::string(version),
      .units = scenario.units,
      .differential_operator = scenario.differential_operator.name(),
      .integrator = scenario.model->steps_itself() ? "own steps" : scenario.time.integrator,
      .model = scenario.model_type,
      .against = scenario.check.against,
      .dimension = scenario.dimension,
      .particles = simulation.model().cloud().count(),
      .steps = moment.step,
      .time = moment.time};
  if (!simulation.model().bodies().empty())
    certificate.bytes_per_particle = peak_bytes_per_particle(simulation.model());
  certificate.pair_work = simulation.model().pair_work();
  certificate.pair_work.evaluations += simulation.integrator().own_evaluations();
  certificate.warnings = simulation.warnings();
  for (const std::string& warning : simulation.model().warnings())
    certificate.warnings.push_back(scenario.name + ": warning: " + warning);
  return certificate;
}

}  // namespace

std::vector<ErrorNorms> errors_of(const Simulation& simulation, double time) {
  const std::vector<Index> particles = compared(simulation.model());
  const Table reference = reference_of(simulation, particles, time);
  const Triple periods = simulation.scenario().periods();
  std::vector<ErrorNorms> errors;
  for (const Column& column : reference)
    for (const Field& field : simulation.model().cloud().fields()) {
      const auto columns = columns_of(field, reference);
      if (!columns.empty() && columns.front() == &column)
        errors.push_back(error_of(field, particles, columns, periods));
    }
  return errors;
}

Certificate certificate_of(const Simulation& simulation, const Moment& moment) {
  const Model& model = simulation.model();
  Certificate certificate = certificate_without_results(simulation, moment);
  certificate.remarks = model.remarks();
  certificate.conservation = drifts(simulation.conserved_at_start(), model.conserved());
  if (simulation.exact() != nullptr) {
    certificate.errors = errors_of(simulation, moment.time);
    certificate.remarks.push_back(simulation.exact()->statement() + ".");
  }
  const Scenario::Check& check = simulation.scenario().check;
  add_checks(check.of(model.frame()), check.norm, certificate);
  return certificate;
}

Certificate failed_certificate(const Simulation& simulation, const Moment& moment,
                               const std::string& failure) {
  Certificate certificate = certificate_without_results(simulation, moment);
  certificate.failure = failure;
  return certificate;
}

}  // namespace mote
