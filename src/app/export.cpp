#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "mote/app/commands.hpp"
#include "mote/output/files.hpp"
#include "mote/output/folder.hpp"
#include "mote/output/tables.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// The number of a frame that exists. Throws InputError.
std::int64_t frame_number(const OutputFolder& folder, const std::string& frame) {
  const auto frames = folder.frames();
  if (frames.empty())
    throw InputError(fmt::format("{}: there are no snapshots", folder.path().string()));
  if (frame == "last") return frames.back();
  std::int64_t number = -1;
  const auto [end, error] = std::from_chars(frame.data(), frame.data() + frame.size(), number);
  if (error != std::errc{} || end != frame.data() + frame.size())
    throw InputError(fmt::format("--frame {}: this must be a number or 'last'", frame));
  if (std::find(frames.begin(), frames.end(), number) == frames.end())
    throw InputError(fmt::format("--frame {}: there are the frames {} to {}", frame, frames.front(),
                                 frames.back()));
  return number;
}

}  // namespace

int export_frame(const ExportOptions& options) {
  const std::filesystem::path to = options.to;
  if (to.extension() != ".csv" && to.extension() != ".vtp")
    throw InputError(fmt::format("--to {}: the file must end in .csv or .vtp", options.to));
  std::error_code error;
  if (std::filesystem::is_directory(to, error))
    throw InputError(fmt::format("{}: this is a folder, not a file", options.to));
  if (std::filesystem::exists(to, error) && !options.overwrite)
    throw InputError(fmt::format("{}: this file exists; --overwrite replaces it", options.to));
  const OutputFolder folder = OutputFolder::open(options.folder);
  const Snapshot snapshot = folder.read_frame(frame_number(folder, options.frame));
  if (to.extension() == ".csv")
    write_file(to, csv_of(snapshot.cloud));
  else
    write_vtp(to, snapshot.cloud);
  return 0;
}

}  // namespace mote
