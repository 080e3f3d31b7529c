#pragma once

#include <vector>

#include "mote/models/model.hpp"
#include "mote/scenario/probes.hpp"

namespace mote {

/// Measures what the section `probes` asks for, in the state that a model in space is in. The same
/// state gives the same bits for any number of threads.
class Observer {
 public:
  /// `period` is the width of the domain along each periodic axis, and 0 along the others. Throws
  /// InputError for a wall or a field that the model does not have, and for a column that is there
  /// already.
  Observer(std::vector<Probe> probes, const Triple& period, const Model& model);

  /// One number a column, in the order of the probes, always under the same names. NaN where there
  /// is nothing to measure: no fluid within sight of a place, no surface above a gauge.
  std::vector<Reading> readings(const Model& model) const;

 private:
  void refuse_what_is_not_there(const Model& model) const;
  void refuse_columns_of_others(const Model& model) const;
  void append(const Probe& probe, const Model& model, std::vector<Reading>& readings) const;

  std::vector<Probe> probes_;
  Triple period_;
};

}  // namespace mote
