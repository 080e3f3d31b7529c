#pragma once

#include <string>
#include <vector>

#include "mote/scenario/document.hpp"
#include "mote/study/error_limits.hpp"

namespace mote {

/// A study file with the key `table`: divided differences of the exponential function, or matrix
/// exponentials, for nodes or eigenvalues that come together, by several schemes beside the exact
/// value. The tables of Nadukandi 2014 are such studies.
struct DifferenceTableFile {
  std::string name;
  std::string table;                 ///< what is evaluated
  std::int64_t decades = 15;         ///< rows: h = 1/10, 1/100, ...
  std::vector<std::string> schemes;  ///< columns

  /// What the relative errors of a scheme must hold: of P, Q or R if the table has these.
  struct Check {
    std::string scheme, quantity;
    ErrorLimits limits;
  };
  std::vector<Check> checks;

  static constexpr bool picture = false;  ///< there is none to draw
};

/// Exact values of one quantity, of a matrix its norm, row by row. Long, as sixteen digits that are
/// cut off and not rounded would not come out of a rounded number.
struct ExactColumn {
  std::string quantity;
  std::vector<long double> values;
};

/// The relative errors of one quantity by one scheme, and what it is, row by row.
struct DifferenceColumn {
  std::string scheme, quantity;
  std::vector<double> values;  ///< of a matrix its norm
  std::vector<double> errors;
};

/// All columns, and the exact values of every quantity.
struct DifferenceTable {
  std::vector<double> h;
  std::vector<ExactColumn> exact;
  std::vector<DifferenceColumn> columns;
};

bool is_difference_table(const Document& document);

/// Reads and checks a document. Throws LocatedError.
DifferenceTableFile read_difference_table(const Document& document);

/// The file as YAML with every default.
std::string resolved_yaml(DifferenceTableFile& file);

/// The JSON Schema of such a file.
std::string difference_table_schema();

DifferenceTable evaluated(const DifferenceTableFile& file);

std::vector<CheckResult> table_checks(const DifferenceTableFile& file,
                                      const DifferenceTable& table);

/// study.csv: h,scheme,quantity,value,exact,error. 17 digits.
std::string table_csv(const DifferenceTable& table);

/// The table for a person, in plain text and in study.md: values with their first 16 digits, cut
/// off as in the tables of Nadukandi 2014 and not rounded.
std::string table_text(const DifferenceTable& table);
std::string table_markdown(const DifferenceTableFile& file, const DifferenceTable& table,
                           const std::vector<std::string>& pictures);

}  // namespace mote
