#include "mote/study/difference_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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
