#include "mote/output/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "mote/output/files.hpp"
#include "mote/output/tables.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

namespace fs = std::filesystem;

namespace {

const FolderKind run_folder{"run",
                            "run.yaml",
                            std::string(run_file_mark),
                            {"summary.json", "report.md", "history.csv", "exact.csv",
                             "snapshots.hdf.series", "fields.png"}};

std::string name_of_frame(std::int64_t frame) { return fmt::format("{:06}.hdf", frame); }

/// The frame that a file name stands for, `000012.hdf`; nothing for other names.
std::optional<std::int64_t> frame_of(const fs::path& file) {
  const std::string name = file.filename().string();
  std::int64_t frame = -1;
  std::from_chars(name.data(), name.data() + name.size(), frame);
  if (frame < 0 || name != name_of_frame(frame)) return std::nullopt;
  return frame;
}

std::vector<std::int64_t> frames_in(const fs::path& folder) {
  std::vector<std::int64_t> frames;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "snapshots", error))
    if (const auto frame = frame_of(entry.path())) frames.push_back(*frame);
  std::ranges::sort(frames);
  return frames;
}

std::vector<fs::path> snapshots_in(const fs::path& folder) {
  std::vector<fs::path> snapshots;
  for (const std::int64_t frame : frames_in(folder))
    snapshots.push_back(folder / "snapshots" / name_of_frame(frame));
  return snapshots;
}

}  // namespace

OutputFolder OutputFolder::create(const fs::path& path, Existing existing) {
  OutputFolder folder(path);
  ClaimedFolder claimed(path, existing, run_folder);
  claimed.remove_former(snapshots_in(path));
  folder.lock_ = claimed.take_lock();
  make_folder(path / "snapshots");
  return folder;
}

bool OutputFolder::is_one(const fs::path& path) {
  std::string first_line;
  return static_cast<bool>(std::getline(std::ifstream(path / "run.yaml"), first_line)) &&
         first_line == run_file_mark;
}

void OutputFolder::remove(const fs::path& path) {
  ClaimedFolder claimed(path, Existing::replace, run_folder);
  claimed.remove_former(snapshots_in(path));
  std::error_code ignored;  // a folder with files of somebody else stays
  fs::remove(path / "snapshots", ignored);
  fs::remove(path, ignored);
}

OutputFolder OutputFolder::open(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored))
    throw InputError(fmt::format("{}: there is no such folder", path.string()));
  if (!fs::exists(path / "run.yaml"))
    throw InputError(
        fmt::format("{}: this is not the output of a run: it has no run.yaml", path.string()));
  return OutputFolder(path);
}

OutputFolder OutputFolder::reopen(const fs::path& path) {
  OutputFolder folder = open(path);
  folder.lock_ = std::make_unique<FolderLock>(path);
  return folder;
}

fs::path OutputFolder::snapshot(std::int64_t frame) const {
  return path_ / "snapshots" / name_of_frame(frame);
}

std::vector<std::int64_t> OutputFolder::frames() const { return frames_in(path_); }

void OutputFolder::add_snapshot(const Moment& moment, const std::string& fingerprint,
                                const Cloud& cloud, const Scene& scene, const Restart& restart) {
  write_snapshot(snapshot(moment.frame), moment, fingerprint, cloud, scene, restart);
  times_.emplace_back(moment.frame, moment.time);
  write_series();
}

Snapshot OutputFolder::read_frame(std::int64_t frame) const {
  Snapshot read = read_snapshot(snapshot(frame));
  if (read.moment.frame != frame)
    throw InputError(fmt::format("{}: this snapshot is damaged: it holds frame {}",
                                 snapshot(frame).string(), read.moment.frame));
  return read;
}

void OutputFolder::restore_series() {
  times_.clear();
  for (const std::int64_t frame : frames())
    times_.emplace_back(frame, read_moment(snapshot(frame)).time);
  write_series();
}

void OutputFolder::write_series() const {
  nlohmann::ordered_json series;
  series["file-series-version"] = "1.0";
  series["files"] = nlohmann::ordered_json::array();
  for (const auto& [frame, time] : times_)
    series["files"].push_back({{"name", "snapshots/" + name_of_frame(frame)}, {"time", time}});
  write_file(file("snapshots.hdf.series"), series.dump(1) + "\n");
}

void OutputFolder::write_table(const std::string& name, const Table& table) const {
  write_file(file(name), csv_of(table));
}

}  // namespace mote
