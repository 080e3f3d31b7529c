#include <fmt/format.h>

#include <algorithm>
#include <boost/tokenizer.hpp>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "mote/input/point_table.hpp"
#include "mote/output/files.hpp"

namespace mote {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr const char* wanted = "the first row must name the columns, as in x,y,mass";

struct Line {
  std::size_t number = 1;
  std::string_view text;
};

struct Cell {
  std::string text;
  std::size_t start;  ///< bytes before it in its line
};

struct Number {
  double value;
  std::errc error;
};

template <class Text>
Text trimmed(const Text& text) {
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

/// UTF-8: some bytes only go on with a character.
std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// The lines that are no comments, up to the last that is not blank.
std::vector<Line> rows_of(std::string_view text) {
  std::vector<Line> rows;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!trimmed(line).starts_with('#'))
      rows.push_back({number, line.substr(0, line.find_last_not_of(blanks) + 1)});
  }
  while (!rows.empty() && rows.back().text.empty()) rows.pop_back();
  return rows;
}

std::vector<Cell> cells_of(std::string_view line) {
  using Separator = boost::escaped_list_separator<char>;
  // No escape character: a name may have a backslash in it.
  const boost::tokenizer<Separator, std::string_view::const_iterator> tokens(
      line.begin(), line.end(), Separator("", ",", "\""));
  std::vector<Cell> cells;
  std::size_t start = 0;
  for (auto token = tokens.begin(); !token.at_end(); ++token) {
    cells.push_back(
        {trimmed(*token), std::min(line.find_first_not_of(blanks, start), line.size())});
    start = static_cast<std::size_t>(token.base() - line.begin());
  }
  return cells;
}

/// The number that all of `text` is. Other than std::from_chars, C and Fortran know a plus sign.
Number number_in(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number.value);
  const bool whole = rest == text.data() + text.size();
  number.error = whole ? error : std::errc::invalid_argument;
  return number;
}

bool is_number(const Cell& cell) {
  return number_in(cell.text).error != std::errc::invalid_argument;
}

/// A file, to be read row by row; knows the place of everything that is wrong with it.
class Csv {
 public:
  enum class Rows { points, numbers };

  Csv(std::string path, std::string_view text, Rows kind)
      : path_(std::move(path)), rows_(rows_of(without_byte_order_mark(text))), kind_(kind) {
    if (text.find('\0') != text.npos) refuse({}, 0, "this is not a text file");
    if (without_byte_order_mark(text).find_first_not_of(" \t\r\n") == text.npos)
      refuse({}, 0, "this file is empty");
    if (rows_.empty()) refuse({}, 0, fmt::format("there is no header; {}", wanted));
  }

  PointTable table() const {
    PointTable table = header();
    for (std::size_t point = 0; point + 1 < rows_.size(); ++point)
      append_point(table, point, rows_[point + 1]);
    if (kind_ == Rows::points) at_place(place(rows_.front(), 0), [&] { check_numbers(table); });
    return table;
  }

 private:
  std::string place(const Line& line, std::size_t start) const {
    return fmt::format("{}:{}:{}", path_, line.number, characters(line.text.substr(0, start)) + 1);
  }

  [[noreturn]] void refuse(const Line& line, std::size_t start, const std::string& message) const {
    throw InputError(place(line, start) + ": " + message);
  }

  std::vector<Cell> cells(const Line& line) const {
    if (std::ranges::count(line.text, '"') % 2 != 0)
      refuse(line, 0, "a quotation mark is not closed");
    return cells_of(line.text);
  }

  /// A table without rows.
  PointTable header() const {
    const Line& line = rows_.front();
    const std::vector<Cell> names = cells(line);
    if (names.empty()) refuse(line, 0, fmt::format("there is no header; {}", wanted));
    if (std::ranges::all_of(names, is_number))
      refuse(line, 0, fmt::format("there are numbers in place of the header; {}", wanted));
    PointTable table;
    for (const Cell& name : names) {
      if (name.text.empty()) refuse(line, name.start, "this column has no name");
      if (table.has(name.text))
        refuse(line, name.start, fmt::format("the column '{}' is there twice", name.text));
      table.columns.emplace_back(name.text, 0).second.reserve(rows_.size() - 1);
    }
    if (kind_ == Rows::points) at_place(place(line, 0), [&] { check_coordinates(table); });
    return table;
  }

  void append_point(PointTable& table, std::size_t point, const Line& line) const {
    const std::vector<Cell> values = cells(line);
    if (values.size() != table.columns.size())
      refuse(line, 0,
             fmt::format("this row has {} cell{}; the header has {}", values.size(),
                         values.size() == 1 ? "" : "s", table.columns.size()));
    for (std::size_t c = 0; c < values.size(); ++c) {
      auto& [name, column] = table.columns[c];
      column.push_back(number(line, values[c], name, point));
    }
  }

  double number(const Line& line, const Cell& cell, const std::string& column,
                std::size_t point) const {
    const auto [value, error] = number_in(cell.text);
    if (error == std::errc::invalid_argument)
      refuse(line, cell.start,
             fmt::format("{} of point {} must be a number, not '{}'", column, point, cell.text));
    if (error == std::errc::result_out_of_range)
      refuse(
          line, cell.start,
          fmt::format("{} of point {} is too large or too small: '{}'", column, point, cell.text));
    if (kind_ == Rows::points && !std::isfinite(value))
      refuse(line, cell.start, not_finite(column, point, value));
    return value;
  }

  std::string path_;
  std::vector<Line> rows_;
  Rows kind_;
};

}  // namespace

PointTable read_csv_points(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  return Csv(path.string(), text, Csv::Rows::points).table();
}

PointTable read_csv_numbers(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  return Csv(path.string(), text, Csv::Rows::numbers).table();
}

}  // namespace mote
