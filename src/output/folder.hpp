#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mote/exact/exact_solution.hpp"
#include "mote/models/model.hpp"
#include "mote/output/snapshot.hpp"

namespace mote {

/// The first line of run.yaml, by which a folder is known as the output of a run.
inline constexpr std::string_view run_file_mark =
    "# The scenario as it was run, with every default.";

/// What to do when the folder of a run is there already.
enum class Existing { refuse, replace };

/// The folder that a run leaves behind: run.yaml, snapshots, history.csv, summary.json, report.md,
/// exact.csv and the picture. Every file in it is whole at any moment.
class OutputFolder {
 public:
  /// Makes the folder for a new run. Replaces a former run's files only if asked to, and never a
  /// folder that is not a run's. Throws InputError.
  static OutputFolder create(const std::filesystem::path& path, Existing existing);

  /// The folder of a run that is there. Throws InputError if it is not one.
  static OutputFolder open(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(const std::string& name) const { return path_ / name; }
  std::filesystem::path snapshot(std::int64_t frame) const;

  /// The frames there are, in order.
  std::vector<std::int64_t> frames() const;

  /// Writes a snapshot and names it in `snapshots.hdf.series` with its time.
  void add_snapshot(const Moment& moment, const std::string& fingerprint, const Cloud& cloud);

  /// The snapshot of a frame. Throws InputError if it is damaged or of another frame.
  Snapshot read_frame(std::int64_t frame) const;

  /// Names a snapshot that is there in the series, and no later one.
  void note_snapshot(const Moment& moment);

  /// Starts history.csv, or cuts off the rows after `moment` of a run that goes on from there.
  void begin_history(const std::vector<Conserved>& quantities);
  void resume_history(const Moment& moment, const std::vector<Conserved>& quantities);
  void add_history(const Moment& moment, const std::vector<Conserved>& quantities);

  /// Writes a table as CSV with 17 digits.
  void write_table(const std::string& name, const Table& table);

 private:
  explicit OutputFolder(std::filesystem::path path) : path_(std::move(path)) {}
  void read_series();
  void write_series() const;

  std::filesystem::path path_;
  std::vector<std::pair<std::int64_t, double>> times_;  ///< of the frames written or found
};

}  // namespace mote
