#include "mote/study/difference_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "mote/scenario/located_error.hpp"
#include "support/program.hpp"

namespace mote {
namespace {

using testing::HasSubstr;

DifferenceTableFile file_of(const std::string& yaml) {
  const test::TemporaryFolder folder;
  const auto path = test::write(folder / "table.yaml", yaml);
  return read_difference_table(Document::from_file(path.string()));
}

TEST(DifferenceTable, HasTheLimitOfEveryQuantity) {
  const auto last = [](const std::string& name) {
    return evaluated(file_of("{name: t, table: " + name + "}")).exact.front().values.back();
  };
  EXPECT_NEAR(last("second_difference"), std::exp(1) / 2, 3e-15);
  EXPECT_NEAR(last("fourth_difference_of_pair"), 1.0 / 24, 1e-16);
  EXPECT_NEAR(last("fourth_difference"), 1.0 / 24, 1e-16);
  EXPECT_NEAR(last("matrices"), std::sqrt(0.75 + 2.0 / 36 + std::pow(1.0 / 6 + 1.0 / 24, 2)),
              1e-14);
}

/// Tables 2 (and 1), 3 and 5 in print, of which 3 and 5 are in units of 1/100: their exact columns,
/// and those of the stable scheme.
struct Printed {
  const char *table, *unit;
  std::vector<std::string> digits, stable;
};

const std::vector<Printed> printed{
    {"second_difference",
     "e+00",
     {"1.503335165136325", "1.372811947550820", "1.360500848315854", "1.359276836249607",
      "1.359154505717948", "1.359142273371229", "1.359141050143621", "1.359140927820931",
      "1.359140915588663", "1.359140914365436", "1.359140914243114", "1.359140914230881",
      "1.359140914229658", "1.359140914229536", "1.359140914229523"},
     {"1.503335165136323", "1.372811947550791", "1.360500848315854", "1.359276836249607",
      "1.359154505717948", "1.359142273371229", "1.359141050143622", "1.359140927820931",
      "1.359140915588663", "1.359140914365436", "1.359140914243114", "1.359140914230881",
      "1.359140914229658", "1.359140914229536", "1.359140914229524"}},
    {"fourth_difference_of_pair",
     "e-02",
     {"4.252986132162584", "4.175027977160363", "4.167500277976287", "4.166750002777976",
      "4.166675000027777", "4.166667500000277", "4.166666750000002", "4.166666675000000",
      "4.166666667500000", "4.166666666750000", "4.166666666675000", "4.166666666667500",
      "4.166666666666750", "4.166666666666675", "4.166666666666667"},
     {"4.252986132163262", "4.175027977159309", "4.167500277976286", "4.166750002777976",
      "4.166675000027778", "4.166667500000277", "4.166666750000002", "4.166666674999999",
      "4.166666667499999", "4.166666666749999", "4.166666666674999", "4.166666666667499",
      "4.166666666666749", "4.166666666666674", "4.166666666666667"}},
    {"fourth_difference",
     "e-02",
     {"4.703252003748591", "4.217015682095156", "4.171670140675349", "4.167166701390674",
      "4.166716667013890", "4.166671666670138", "4.166667166666701", "4.166666716666667",
      "4.166666671666666", "4.166666667166666", "4.166666666716666", "4.166666666671666",
      "4.166666666667166", "4.166666666666716", "4.166666666666671"},
     {"4.703252003756346", "4.217015682094985", "4.171670140675349", "4.167166701390674",
      "4.166716667013890", "4.166671666670138", "4.166667166666701", "4.166666716666667",
      "4.166666671666666", "4.166666667166666", "4.166666666716666", "4.166666666671665",
      "4.166666666667166", "4.166666666666716", "4.166666666666671"}}};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(DifferenceTable, PrintsTheExactDigitsOfThePaper) {
  for (const auto& [name, unit, digits, stable] : printed) {
    const auto file = file_of("{name: t, table: " + std::string(name) + ", schemes: [accurate]}");
    const auto lines = lines_of(table_text(evaluated(file)));
    ASSERT_EQ(lines.size(), 1 + digits.size());
    for (std::size_t row = 0; row < digits.size(); ++row)
      EXPECT_THAT(lines[row + 1], HasSubstr(" " + digits[row] + unit + "  ")) << name;
  }
}

/// Where the paper's scheme gave it the exact digits, it does so here, in the second column.
TEST(DifferenceTable, PrintsTheStableDigitsOfThePaperWhereTheyAreRight) {
  for (const auto& [name, unit, digits, stable] : printed) {
    const auto file = file_of("{name: t, table: " + std::string(name) + ", schemes: [piecewise]}");
    const auto lines = lines_of(table_text(evaluated(file)));
    int right = 0;
    for (std::size_t row = 0; row < digits.size(); ++row) {
      if (stable[row] != digits[row]) continue;
      ++right;
      const std::string word = " " + digits[row] + unit + " ", &line = lines.at(row + 1);
      EXPECT_NE(line.find(word), line.rfind(word)) << name << ": " << line;
    }
    EXPECT_GE(right, 4) << name;
  }
}

/// A rounded last digit would be wrong.
TEST(DifferenceTable, CutsDigitsOff) {
  DifferenceTable table{.h = {0.1}, .exact = {{"a", {2.0L / 3}}}, .columns = {}};
  table.columns.push_back({"accurate", "a", {-2.0 / 3}, {0}});
  EXPECT_THAT(table_text(table), HasSubstr(" 6.666666666666666e-01  -6.666666666666666e-01 (16)"));
}

TEST(DifferenceTable, TellsSchemesApart) {
  const auto file = file_of(R"({name: t, table: fourth_difference, check: [
      {scheme: usual, least_error: 1.0e+20}, {scheme: usual, error: 1.0e-10},
      {scheme: piecewise, error: 1.0e-10}, {scheme: accurate, error: 1.0e-15}]})");
  const auto checks = table_checks(file, evaluated(file));
  ASSERT_EQ(checks.size(), 4);
  EXPECT_TRUE(checks[0].passed());
  EXPECT_FALSE(checks[1].passed());
  EXPECT_TRUE(checks[2].passed());
  EXPECT_TRUE(checks[3].passed());
}

TEST(DifferenceTable, IsWrittenForPeopleAndPrograms) {
  const auto file = file_of("{name: t, table: matrices, schemes: [accurate], decades: 2}");
  const auto table = evaluated(file);
  EXPECT_EQ(table.columns.size(), 3);
  EXPECT_THAT(table_markdown(file, table, {}),
              HasSubstr("| h | R accurate | Q accurate | P accurate |"));
  const std::string csv = table_csv(table);
  EXPECT_THAT(csv,
              HasSubstr("h,scheme,quantity,value,exact,error\n0.10000000000000001,accurate,R,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 2);
}

TEST(DifferenceTable, ReadsWhatItWrites) {
  auto file = file_of("{name: t, table: second_difference, check: [{scheme: accurate, error: 1}]}");
  const std::string written = resolved_yaml(file);
  auto again = file_of(written);
  EXPECT_EQ(resolved_yaml(again), written);
  EXPECT_EQ(again.schemes.size(), 5);
}

TEST(DifferenceTable, RefusesWhatItDoesNotHave) {
  EXPECT_THROW(file_of("{name: t, table: fifth_difference}"), LocatedError);
  EXPECT_THROW(file_of("{name: t, table: matrices, schemes: [recursive]}"), LocatedError);
  EXPECT_THROW(file_of("{name: t, table: matrices, schemes: [usual], check: [{scheme: accurate}]}"),
               LocatedError);
  EXPECT_THROW(file_of("{name: a/b, table: matrices}"), LocatedError);
}

}  // namespace
}  // namespace mote
