#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mote/options/description.hpp"
#include "mote/scenario/document.hpp"

namespace mote {

/// One of the section `probes`: what is measured whenever history.csv gets a row. Which keys have a
/// meaning depends on the type.
struct Probe {
  std::string name, type;
  std::vector<double> at;           ///< of a point; of a gauge without the last axis
  std::vector<double> from, to;     ///< ends of a line
  std::int64_t points = 101;        ///< on a line, both ends among them
  std::vector<std::string> fields;  ///< of a point or line: velocity, velocity_x, pressure, ...
  bool all = false;                 ///< whether each point of a line has columns of its own
  std::string wall;                 ///< the wall whose force is measured
  std::string along = "x";          ///< the way in which the front of the fluid runs: x, -x, ...
};

/// Says what the section holds.
void describe_probes(Description& description, std::vector<Probe>& probes);

/// The domain that probes are in.
struct ProbeDomain {
  std::size_t dimension;
  std::vector<double> lower, upper;
};

/// Refuses what no single key can state: places outside of the domain or in another dimension, and
/// names that are no names. Throws LocatedError.
void check_probes(const std::vector<Probe>& probes, const ProbeDomain& domain,
                  const Document& document);

}  // namespace mote
