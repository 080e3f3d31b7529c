#include <fmt/format.h>

#include "mote/scenario/folder_name.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/reader.hpp"
#include "mote/scenario/schema.hpp"
#include "mote/scenario/writer.hpp"
#include "mote/study/difference_table.hpp"

namespace mote {
namespace {

const Choices tables{
    {"second_difference", "exp[1; 1+h; 1+2h]: Tables 1 and 2"},
    {"fourth_difference_of_pair", "Phi(2h)[-h; -h; 3h]: Table 3"},
    {"matrices_of_pair", "P, Q and R for the eigenvalues h+2ih, h-2ih and 4h: Table 4"},
    {"fourth_difference", "r[h; 2h; 3h]: Table 5"},
    {"matrices", "P, Q and R for the eigenvalues h, 2h and 3h: Table 6"}};

Choices schemes_of(const std::string& table) {
  const Choice piecewise{"piecewise", "the stable piecewise formulas"};
  const Choice accurate{"accurate", "mote's default"};
  if (table == "second_difference")
    return {{"recursive", "Formula1"},
            {"collected", "Formula2"},
            {"piecewise_one_term", "Formula3: one term of the series"},
            piecewise,
            accurate};
  return {{"usual", "the formulas as they stand"}, piecewise, accurate};
}

bool has_matrices(const std::string& table) { return table.starts_with("matrices"); }

void describe_check(Description& d, DifferenceTableFile::Check& check, const std::string& table) {
  d.choice({"scheme", "which column", true}, check.scheme, schemes_of(table));
  if (has_matrices(table))
    d.choice({"quantity", "which matrix; default: all"}, check.quantity,
             {{"P", "e^A"}, {"Q", "the integral of P"}, {"R", "the integral of Q"}});
  check.limits.describe(d);
}

void describe(Description& d, DifferenceTableFile& file) {
  d.text({"name", "names the output folder and the report", true}, file.name);
  d.variant({"table", "what is evaluated", true}, file.table, tables,
            [&](const std::string& table) {
              file.table = table;
              d.words({"schemes", "the columns; default: all"}, file.schemes, schemes_of(table));
              describe_list(d, {"check", "what the errors must hold"}, file.checks,
                            [&](auto& check) { describe_check(d, check, table); });
            });
  d.count({"decades", "rows: h = 1/10, 1/100, ..."}, file.decades, {1, 18});
}

}  // namespace

bool is_difference_table(const Document& document) {
  return document.root().find("table") != nullptr && document.root().find("model") == nullptr;
}

DifferenceTableFile read_difference_table(const Document& document) {
  DifferenceTableFile file;
  Reader reader(document, "the study");
  describe(reader, file);
  reader.finish();
  const std::string problem = folder_name_problem(file.name);
  if (!problem.empty()) throw LocatedError(document.locate("name"), problem);
  if (file.schemes.empty())
    for (const Choice& scheme : schemes_of(file.table)) file.schemes.push_back(scheme.name);
  for (std::size_t k = 0; k < file.checks.size(); ++k) {
    if (std::ranges::find(file.schemes, file.checks[k].scheme) == file.schemes.end())
      throw LocatedError(document.locate(fmt::format("check.{}.scheme", k)),
                         fmt::format("the table has no column '{}'", file.checks[k].scheme));
    file.checks[k].limits.refuse_senseless(document.locate(fmt::format("check.{}", k)));
  }
  return file;
}

std::string resolved_yaml(DifferenceTableFile& file) {
  return yaml_of([&](Description& d) { describe(d, file); });
}

std::string difference_table_schema() {
  return schema_of("mote study of divided differences", [](Description& description) {
    DifferenceTableFile file;
    describe(description, file);
  });
}

}  // namespace mote
