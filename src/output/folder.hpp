#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mote/exact/exact_solution.hpp"
#include "mote/output/claim_folder.hpp"
#include "mote/output/folder_lock.hpp"
#include "mote/output/history.hpp"
#include "mote/output/snapshot.hpp"

namespace mote {

/// The first line of run.yaml, by which a folder is known as the output of a run.
inline constexpr std::string_view run_file_mark =
    "# The scenario as it was run, with every default.";

/// The folder that a run leaves behind: run.yaml, snapshots, history.csv, summary.json, report.md,
/// exact.csv and the picture. A file in it is whole at any moment, but for the last row of
/// history.csv.
class OutputFolder {
 public:
  /// Makes the folder for a new run, and keeps other runs out of it. Replaces a former run's files
  /// only if asked to, and nothing else. Throws InputError.
  static OutputFolder create(const std::filesystem::path& path, Existing existing);

  /// The folder of a run that is there, to read. Throws InputError if it is not one.
  static OutputFolder open(const std::filesystem::path& path);

  /// The same to go on writing, with other runs kept out.
  static OutputFolder reopen(const std::filesystem::path& path);

  /// Whether a folder is the output of a run.
  static bool is_one(const std::filesystem::path& path);
  /// Removes the output of a run, and the folder if nothing else is in it. Throws InputError if it
  /// is not one.
  static void remove(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(const std::string& name) const { return path_ / name; }
  std::filesystem::path snapshot(std::int64_t frame) const;
  History history() const { return History(file("history.csv")); }

  /// The frames there are, in order.
  std::vector<std::int64_t> frames() const;

  /// The snapshot of a frame. Throws InputError if it is damaged or of another frame.
  Snapshot read_frame(std::int64_t frame) const;

  /// Writes a snapshot and names it in `snapshots.hdf.series` with its time.
  void add_snapshot(const Moment& moment, const std::string& fingerprint, const Cloud& cloud,
                    const Scene& scene, const Restart& restart = {});

  /// Writes `snapshots.hdf.series` anew from the snapshots that are there.
  void restore_series();

  /// Writes a table as CSV with 17 digits.
  void write_table(const std::string& name, const Table& table) const;

 private:
  explicit OutputFolder(std::filesystem::path path) : path_(std::move(path)) {}
  void write_series() const;

  std::filesystem::path path_;
  std::unique_ptr<FolderLock> lock_;
  std::vector<std::pair<std::int64_t, double>> times_;  ///< of the frames in the series
};

}  // namespace mote
