#include "mote/observe/observer.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "mote/observe/measures.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

Observer::Observer(std::vector<Probe> probes, const Triple& period, const Model& model)
    : probes_(std::move(probes)), period_(period) {
  refuse_what_is_not_there(model);
  refuse_columns_of_others(model);
}

void Observer::refuse_what_is_not_there(const Model& model) const {
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    const Probe& probe = probes_[k];
    std::string key = fmt::format("probes.{}.wall", k);
    try {
      if (probe.type == "force") wall_named(probe.wall, model);
      for (std::size_t f = 0; f < probe.fields.size(); ++f) {
        key = fmt::format("probes.{}.fields.{}", k, f);
        columns_of(probe.fields[f], model.cloud());
      }
    } catch (const InputError& problem) {
      throw InputError(key, problem.what());
    }
  }
}

void Observer::refuse_columns_of_others(const Model& model) const {
  std::set<std::string> taken{"time", "step"};
  for (const Conserved& quantity : model.conserved()) taken.insert(quantity.name);
  for (const Reading& reading : model.readings()) taken.insert(reading.name);
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    std::vector<Reading> readings;
    append(probes_[k], model, readings);
    for (const Reading& reading : readings)
      if (!taken.insert(reading.name).second)
        throw InputError(
            fmt::format("probes.{}.name", k),
            fmt::format("history.csv has a column '{}' already, other than that of this probe",
                        reading.name));
  }
}

std::vector<Reading> Observer::readings(const Model& model) const {
  std::vector<Reading> readings;
  for (const Probe& probe : probes_) append(probe, model, readings);
  return readings;
}

void Observer::append(const Probe& probe, const Model& model,
                      std::vector<Reading>& readings) const {
  std::vector<Reading> more;
  if (probe.type == "point") more = point_readings(probe, period_, model);
  if (probe.type == "line") more = line_readings(probe, period_, model);
  if (probe.type == "gauge") more = gauge_readings(probe, period_, model);
  if (probe.type == "front") more = front_readings(probe, model);
  if (probe.type == "speed") more = speed_readings(probe, model);
  if (probe.type == "force") more = force_readings(probe, model);
  readings.insert(readings.end(), more.begin(), more.end());
}

}  // namespace mote
