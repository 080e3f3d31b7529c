#include <gmock/gmock.h>

#include "input/refusal.hpp"
#include "mote/output/tables.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;

PointTable table_of(const std::string& text) {
  const TemporaryFolder folder;
  return read_points(write(folder / "a.csv", text));
}

TEST(CsvPoints, AreColumnsInAnyOrder) {
  const PointTable table = table_of("mass,y,id,x\n1,2,0,3\n-4e-3,.5,1,6.\n");
  EXPECT_EQ(names_of(table), "mass,y,id,x");
  EXPECT_THAT(table.column("x"), ElementsAre(3, 6));
  EXPECT_THAT(table.column("y"), ElementsAre(2, 0.5));
  EXPECT_THAT(table.column("mass"), ElementsAre(1, -4e-3));
  EXPECT_THAT(table.column("id"), ElementsAre(0, 1));
}

TEST(CsvPoints, KeepEveryBitThatMoteWrites) {
  Cloud cloud(2, 3);
  double next = 1.0 / 3;
  for (double& value : cloud.values("position")) value = next *= -1.0 / 7;
  const PointTable table = table_of(csv_of(cloud));
  EXPECT_EQ(names_of(table), "id,x,y");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(table.column("x")[i], cloud.values("position")[2 * i]);
    EXPECT_EQ(table.column("y")[i], cloud.values("position")[2 * i + 1]);
  }
}

struct Spelling {
  const char* name;
  const char* text;
};

class CsvSpellings : public testing::TestWithParam<Spelling> {};
INSTANTIATE_TEST_SUITE_P(
    All, CsvSpellings,
    testing::Values(Spelling{"plain", "x,a b\n1,2\n3,4\n"},
                    Spelling{"no_end_of_line", "x,a b\n1,2\n3,4"},
                    Spelling{"windows", "x,a b\r\n1,2\r\n3,4\r\n"},
                    Spelling{"byte_order_mark", "\xEF\xBB\xBFx,a b\n1,2\n3,4\n"},
                    Spelling{"blank_end", "x,a b\n1,2\n3,4\n\n  \r\n\t\n"},
                    Spelling{"blanks", "  x , a b\t\n 1\t, 2 \n3 ,4\n"},
                    Spelling{"quotes", "\"x\", \"a b\" \n\"1\",2\n3,\" 4\"\n"},
                    Spelling{"comments", "# of, \"me\n#\nx,a b\n1,2\n #1,2,3\n3,4\n\n# end\n"},
                    Spelling{"plus_signs", "x,a b\n+1,+2e+0\n3,4\n"}),
    [](const auto& test) { return test.param.name; });

TEST_P(CsvSpellings, MeanTheSame) {
  const PointTable table = table_of(GetParam().text);
  EXPECT_EQ(names_of(table), "x,a b");
  EXPECT_THAT(table.column("x"), ElementsAre(1, 3));
  EXPECT_THAT(table.column("a b"), ElementsAre(2, 4));
}

TEST(CsvPoints, MayHaveOddNames) {
  EXPECT_EQ(names_of(table_of("x,\\rho,\"a,b\",\xCF\x81\n1,2,3,4\n")), "x,\\rho,a,b,\xCF\x81");
}

struct Refused {
  const char* name;
  std::string text;
  const char* message;
};

class CsvRefusals : public testing::TestWithParam<Refused> {};

TEST_P(CsvRefusals, SayPlaceAndReason) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal(write(folder / "a.csv", GetParam().text)),
            std::string("a.csv:") + GetParam().message);
}

constexpr auto name_of = [](const auto& test) { return test.param.name; };

INSTANTIATE_TEST_SUITE_P(
    Headers, CsvRefusals,
    testing::Values(
        Refused{"empty", "", "1:1: this file is empty"},
        Refused{"only_a_mark", "\xEF\xBB\xBF", "1:1: this file is empty"},
        Refused{"only_blanks", "\n \r\n", "1:1: this file is empty"},
        Refused{"only_comments", "# a\n# b\n",
                "1:1: there is no header; the first row must name the columns, as in x,y,mass"},
        Refused{"blank_header", "#\n\nx\n1\n",
                "2:1: there is no header; the first row must name the columns, as in x,y,mass"},
        Refused{"numbers", "1,-2e3,nan\n4,5,6\n",
                "1:1: there are numbers in place of the header; the first row must name the "
                "columns, as in x,y,mass"},
        Refused{"commented_header", "# x,y\n1,2\n",
                "2:1: there are numbers in place of the header; the first row must name the "
                "columns, as in x,y,mass"},
        Refused{"twice", "x, mass,y,mass\n1,2,3,4\n", "1:11: the column 'mass' is there twice"},
        Refused{"twice_behind_greek", "x,\xCF\x81,\xCF\x81\n1,2,3\n",
                "1:5: the column '\xCF\x81' is there twice"},
        Refused{"no_name", "x,,y\n1,2,3\n", "1:3: this column has no name"},
        Refused{"no_last_name", "x,y,\n1,2,3\n", "1:5: this column has no name"},
        Refused{"no_x", "# a\nX,y\n1,2\n", "2:1: there is no column x; there are: X, y"},
        Refused{"y_alone", "y\n1\n", "1:1: there is no column x; there are: y"},
        Refused{"z_without_y", "x,z\n1,2\n", "1:1: there is a column z, but no column y"},
        Refused{"semicolons", "x;y\n1;2\n", "1:1: there is no column x; there are: x;y"},
        Refused{"open_quote", "\"x,y\n1,2\n", "1:1: a quotation mark is not closed"},
        Refused{"not_text", std::string("x\n1\0\n", 5), "1:1: this is not a text file"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Rows, CsvRefusals,
    testing::Values(
        Refused{"none", "#\nx,y\n\n", "2:1: there are no points"},
        Refused{"short_row", "x,y\n1,2\n3\n", "3:1: this row has 1 cell; the header has 2"},
        Refused{"long_row", "x,y\n1,2,3\n", "2:1: this row has 3 cells; the header has 2"},
        Refused{"comma_at_the_end", "x,y\n1,2,\n", "2:1: this row has 3 cells; the header has 2"},
        Refused{"blank_between", "x\n1\n \n2\n", "3:1: this row has 0 cells; the header has 1"},
        Refused{"open_quote", "x,y\n1,\"2\n", "2:1: a quotation mark is not closed"},
        Refused{"word", "x,y\n1,2\n# a\n3,  abc\n",
                "4:5: y of point 1 must be a number, not 'abc'"},
        Refused{"nothing", "x,y,m\n1,,3\n", "2:3: y of point 0 must be a number, not ''"},
        Refused{"unit", "x\n1 m\n", "2:1: x of point 0 must be a number, not '1 m'"},
        Refused{"fortran", "x\n1.0D+00\n", "2:1: x of point 0 must be a number, not '1.0D+00'"},
        Refused{"hexadecimal", "x\n0x10\n", "2:1: x of point 0 must be a number, not '0x10'"},
        Refused{"two_signs", "x\n+-1\n", "2:1: x of point 0 must be a number, not '+-1'"},
        Refused{"only_a_sign", "x\n+\n", "2:1: x of point 0 must be a number, not '+'"},
        Refused{"second_header", "x,y\n1,2\nx,y\n", "3:1: x of point 1 must be a number, not 'x'"},
        Refused{"not_a_number", "y,x\n1,2\n3,NaN\n", "3:3: x of point 1 is not a number"},
        Refused{"infinite", "x,y,z\n1,2,-inf\n", "2:5: z of point 0 is infinite"},
        Refused{"infinite_field", "x,mass\n1,+Infinity\n", "2:3: mass of point 0 is infinite"},
        Refused{"too_large", "x\n1e999\n", "2:1: x of point 0 is too large or too small: '1e999'"},
        Refused{"too_small", "x\n-1e-999\n",
                "2:1: x of point 0 is too large or too small: '-1e-999'"}),
    name_of);

TEST(CsvPoints, MayBeTheSmallestNumbers) {
  EXPECT_THAT(table_of("x\n1e-310\n1.7e308\n").column("x"), ElementsAre(1e-310, 1.7e308));
}

}  // namespace
}  // namespace mote::test
