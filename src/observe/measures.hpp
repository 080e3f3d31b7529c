#pragma once

#include <vector>

#include "mote/models/model.hpp"
#include "mote/scenario/probes.hpp"

namespace mote {

/// What the types of probes measure, one function each, as columns. `period` is that of Observer.

/// name_pressure, name_velocity_x, ... at a place.
std::vector<Reading> point_readings(const Probe& probe, const Triple& period, const Model& model);

/// name_pressure_min, name_pressure_max, ... over those places on the line that see fluid; and
/// name_pressure_0, name_pressure_1, ... from the first end to the second, if asked for.
std::vector<Reading> line_readings(const Probe& probe, const Triple& period, const Model& model);

/// name: coordinate along the last axis of the highest place above the gauge where the fluid fills
/// one half of its surroundings.
std::vector<Reading> gauge_readings(const Probe& probe, const Triple& period, const Model& model);

/// name: coordinate of the furthest edge of the fluid, half a spacing beyond its furthest particle.
std::vector<Reading> front_readings(const Probe& probe, const Model& model);

/// name_max and name_rms: largest and root mean square speed of the fluid's particles.
std::vector<Reading> speed_readings(const Probe& probe, const Model& model);

/// name_x, name_y[, name_z]: force of the fluid on a wall.
std::vector<Reading> force_readings(const Probe& probe, const Model& model);

/// The number of the wall of this name; throws InputError without a key if there is none.
std::size_t wall_named(const std::string& name, const Model& model);

/// The columns that a word of `fields` stands for: a field, all components of a vector, or one.
struct FieldColumn {
  std::string name;   ///< velocity_x
  std::string field;  ///< velocity
  int component = 0, components = 1;
};

/// Throws InputError without a key if the cloud has no such field.
std::vector<FieldColumn> columns_of(const std::string& word, const Cloud& cloud);

}  // namespace mote
