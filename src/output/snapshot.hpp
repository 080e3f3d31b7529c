#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mote/models/model.hpp"
#include "mote/particles/cloud.hpp"

namespace mote {

/// Where in a run a snapshot was taken.
struct Moment {
  std::int64_t frame = 0;
  std::int64_t step = 0;
  double time = 0;
};

/// What a snapshot tells a reader about the particles' surroundings, beside their state.
struct Scene {
  double spacing = 0;            ///< between particles of a flow [m]; 0 on a line
  std::span<const Body> bodies;  ///< that the field `body` numbers
};
Scene scene_of(const Model& model);

/// What a run goes on from after a snapshot where that is more than the state shown: the start of
/// the last step taken, which may be before the snapshot, and what it depended on.
struct Restart {
  std::int64_t step = 0;
  double time = 0;
  std::vector<double> values;      ///< all that drifts, then all that is kicked
  std::vector<double> rounding;    ///< what it lost in them, where that is kept
  std::vector<double> integrator;  ///< the integrator's memory
  std::vector<double> path;        ///< that of the path between the ends of steps

  bool empty() const { return values.empty() && integrator.empty(); }
};

/// A snapshot as it stands in a file: the state and which run it belongs to.
struct Snapshot {
  Moment moment;
  std::string fingerprint;  ///< of the resolved scenario
  Cloud cloud;
  Restart restart;
};

/// Writes a snapshot as one HDF5 file: the group `VTKHDF` (1.0, unstructured grid of one
/// poly-vertex cell) that ParaView 5.11 and VTK 9.1 open, and the group `mote` for restart. The
/// file appears whole or not at all, and depends on what is passed alone. Throws InputError.
void write_snapshot(const std::filesystem::path& path, const Moment& moment,
                    const std::string& fingerprint, const Cloud& cloud, const Scene& scene = {},
                    const Restart& restart = {});

/// When a snapshot was taken, without reading its state. Throws InputError as below.
Moment read_moment(const std::filesystem::path& path);

/// Reads a snapshot. Throws InputError for a file that is damaged or not ours.
Snapshot read_snapshot(const std::filesystem::path& path);

}  // namespace mote
