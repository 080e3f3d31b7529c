#pragma once

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace mote::test {

/// A table of the study's own files: a row of names, then rows of cells, no quotes.
struct CsvTable {
  using Row = std::map<std::string, std::string>;
  std::vector<std::string> names;
  std::vector<Row> rows;

  explicit CsvTable(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    names = cells(line);
    while (std::getline(lines, line)) {
      const auto values = cells(line);
      if (values.size() != names.size())
        throw std::runtime_error("a row of " + std::to_string(values.size()) + " cells: " + line);
      Row& row = rows.emplace_back();
      for (std::size_t c = 0; c < names.size(); ++c) row[names[c]] = values[c];
    }
  }

  /// The rows that have these cells.
  std::vector<Row> where(const Row& chosen) const {
    std::vector<Row> found;
    std::ranges::copy_if(rows, std::back_inserter(found), [&](const Row& row) {
      return std::ranges::all_of(
          chosen, [&](const auto& cell) { return row.at(cell.first) == cell.second; });
    });
    return found;
  }

 private:
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    return cells;
  }
};

/// A column of rows as numbers.
inline std::vector<double> numbers(const std::vector<CsvTable::Row>& rows,
                                   const std::string& name) {
  std::vector<double> numbers;
  for (const auto& row : rows) numbers.push_back(std::stod(row.at(name)));
  return numbers;
}

}  // namespace mote::test
