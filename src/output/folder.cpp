#include "mote/output/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "mote/output/files.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

namespace fs = std::filesystem;

namespace {

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw InputError(
        fmt::format("{}: cannot make this folder: {}", path.string(), error.message()));
}

/// Removes a former run, file by file as a run makes them; anything else in the folder stays.
void remove_run(const fs::path& path) {
  std::string first_line;
  std::getline(std::ifstream(path / "run.yaml"), first_line);
  if (first_line != run_file_mark)
    throw InputError(fmt::format(
        "{}: this folder is not the output of a run, so it is not overwritten", path.string()));
  std::error_code error;
  fs::remove_all(path / "snapshots", error);
  for (const char* name : {"run.yaml", "summary.json", "report.md", "history.csv", "exact.csv",
                           "snapshots.hdf.series", "fields.png"})
    if (!error) fs::remove(path / name, error);
  if (error)
    throw InputError(
        fmt::format("{}: cannot remove the former run: {}", path.string(), error.message()));
}

/// The frame that a file name stands for, `000012.hdf`; nothing for other names.
std::optional<std::int64_t> frame_of(const fs::path& file) {
  const std::string stem = file.stem().string();
  std::int64_t frame = 0;
  const auto [end, problem] = std::from_chars(stem.data(), stem.data() + stem.size(), frame);
  const bool number = problem == std::errc{} && end == stem.data() + stem.size();
  if (!number || file.extension() != ".hdf") return std::nullopt;
  return frame;
}

std::string history_header(const std::vector<Conserved>& quantities) {
  std::string header = "time,step";
  for (const Conserved& quantity : quantities) header += "," + quantity.name;
  return header + "\n";
}

}  // namespace

OutputFolder OutputFolder::create(const fs::path& path, Existing existing) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw InputError(fmt::format("{}: this is a file, not a folder", path.string()));
  if (fs::exists(path, error) && !fs::is_empty(path, error)) {
    if (existing == Existing::refuse)
      throw InputError(
          fmt::format("{}: this folder exists and is not empty; --overwrite replaces a former run",
                      path.string()));
    remove_run(path);
  }
  make_folder(path / "snapshots");
  return OutputFolder(path);
}

OutputFolder OutputFolder::open(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored))
    throw InputError(fmt::format("{}: there is no such folder", path.string()));
  if (!fs::exists(path / "run.yaml"))
    throw InputError(
        fmt::format("{}: this is not the output of a run: it has no run.yaml", path.string()));
  OutputFolder folder(path);
  if (!fs::exists(folder.file("snapshots.hdf.series"))) return folder;
  folder.read_series();
  return folder;
}

void OutputFolder::read_series() {
  const fs::path path = file("snapshots.hdf.series");
  try {
    const auto series = nlohmann::json::parse(read_file(path));
    for (const auto& entry : series.at("files")) {
      const auto frame = frame_of(entry.at("name").get<std::string>());
      if (!frame) throw InputError("no frame");
      times_.emplace_back(*frame, entry.at("time").get<double>());
    }
  } catch (const std::exception&) {
    throw InputError(
        fmt::format("{}: this file is damaged: it does not name snapshots and "
                    "their times",
                    path.string()));
  }
}

fs::path OutputFolder::snapshot(std::int64_t frame) const {
  return path_ / "snapshots" / fmt::format("{:06}.hdf", frame);
}

std::vector<std::int64_t> OutputFolder::frames() const {
  std::vector<std::int64_t> frames;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path_ / "snapshots", error))
    if (const auto frame = frame_of(entry.path())) frames.push_back(*frame);
  std::ranges::sort(frames);
  return frames;
}

void OutputFolder::add_snapshot(const Moment& moment, const std::string& fingerprint,
                                const Cloud& cloud) {
  write_snapshot(snapshot(moment.frame), moment, fingerprint, cloud);
  note_snapshot(moment);
}

Snapshot OutputFolder::read_frame(std::int64_t frame) const {
  Snapshot read = read_snapshot(snapshot(frame));
  if (read.moment.frame != frame)
    throw InputError(fmt::format("{}: this snapshot is damaged: it holds frame {}",
                                 snapshot(frame).string(), read.moment.frame));
  return read;
}

void OutputFolder::note_snapshot(const Moment& moment) {
  std::erase_if(times_, [&](const auto& entry) { return entry.first >= moment.frame; });
  times_.emplace_back(moment.frame, moment.time);
  write_series();
}

void OutputFolder::write_series() const {
  nlohmann::ordered_json series;
  series["file-series-version"] = "1.0";
  series["files"] = nlohmann::ordered_json::array();
  for (const auto& [frame, time] : times_)
    series["files"].push_back(
        {{"name", fmt::format("snapshots/{:06}.hdf", frame)}, {"time", time}});
  write_file(file("snapshots.hdf.series"), series.dump(1) + "\n");
}

void OutputFolder::begin_history(const std::vector<Conserved>& quantities) {
  write_file(file("history.csv"), history_header(quantities));
}

void OutputFolder::resume_history(const Moment& moment, const std::vector<Conserved>& quantities) {
  std::istringstream history(read_file(file("history.csv")));
  std::string kept, line;
  std::getline(history, line);
  kept = line + "\n";
  if (kept != history_header(quantities))
    throw InputError(
        fmt::format("{}: this file is damaged: its first line does not name the "
                    "columns of this run",
                    file("history.csv").string()));
  while (std::getline(history, line)) {
    const auto comma = line.find(',');
    std::int64_t step = 0;
    if (comma == std::string::npos) break;
    std::from_chars(line.data() + comma + 1, line.data() + line.size(), step);
    if (step > moment.step) break;
    kept += line + "\n";
  }
  write_file(file("history.csv"), kept);
}

void OutputFolder::add_history(const Moment& moment, const std::vector<Conserved>& quantities) {
  std::string row = fmt::format("{:.17g},{}", moment.time, moment.step);
  for (const Conserved& quantity : quantities)
    fmt::format_to(std::back_inserter(row), ",{:.17g}", quantity.value);
  std::ofstream history(file("history.csv"), std::ios::app);
  history << row + "\n";
  if (!history.flush())
    throw InputError(fmt::format("{}: cannot write this file", file("history.csv").string()));
}

void OutputFolder::write_table(const std::string& name, const Table& table) {
  std::string text;
  for (const Column& column : table) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (std::size_t row = 0; !table.empty() && row < table[0].values.size(); ++row) {
    for (std::size_t c = 0; c < table.size(); ++c)
      fmt::format_to(std::back_inserter(text), "{}{:.17g}", c > 0 ? "," : "", table[c].values[row]);
    text += '\n';
  }
  write_file(file(name), text);
}

}  // namespace mote
