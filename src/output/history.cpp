#include "mote/output/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>

#include "mote/output/files.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

std::string header_of(const std::vector<Reading>& columns) {
  std::string header = "time,step";
  for (const Reading& column : columns) header += "," + column.name;
  return header;
}

/// The step of a row, its second number.
std::int64_t step_of(const std::string& row) {
  std::int64_t step = 0;
  const auto comma = row.find(',');
  if (comma != std::string::npos)
    std::from_chars(row.data() + comma + 1, row.data() + row.size(), step);
  return step;
}

}  // namespace

void History::begin(const std::vector<Reading>& columns) const {
  write_file(path_, header_of(columns) + "\n");
}

void History::resume(const Moment& moment, const std::vector<Reading>& columns) const {
  const std::string text = read_file(path_), header = header_of(columns);
  // What follows the last line end is a row cut short.
  std::istringstream whole_rows(text.substr(0, text.rfind('\n') + 1));
  std::string row;
  if (!std::getline(whole_rows, row) || row != header)
    throw InputError(fmt::format(
        "{}: this file is damaged: its first line does not name the columns of this run",
        path_.string()));
  std::string kept = header + "\n";
  const auto commas = std::ranges::count(header, ',');
  while (std::getline(whole_rows, row) && step_of(row) <= moment.step &&
         std::stod(row) <= moment.time && std::ranges::count(row, ',') == commas)
    kept += row + "\n";
  write_file(path_, kept);
}

void History::add(const Moment& moment, const std::vector<Reading>& columns) const {
  std::string row = fmt::format("{:.17g},{}", moment.time, moment.step);
  for (const Reading& column : columns)
    fmt::format_to(std::back_inserter(row), ",{:.17g}", column.value);
  std::ofstream file(path_, std::ios::app);
  file << row + "\n";
  if (!file.flush()) throw InputError(fmt::format("{}: cannot write this file", path_.string()));
}

}  // namespace mote
