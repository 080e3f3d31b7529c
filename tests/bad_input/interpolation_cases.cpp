// Studies of interpolation that are wrong.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// A good study of interpolation with some lines replaced.
std::string of_interpolation(const std::map<int, std::string>& edits) {
  static constexpr std::array<std::string_view, 4> good{
      /* 1 */ "name: base",
      /* 2 */ "interpolation: {eccentricities: [0, 0.5], sub_intervals: [3, 5]}",
      /* 3 */ "output: {picture: false}",
      /* 4 */ "check: [{path: cubic_hermite, eccentricity: 0.5, sub_intervals: 5, error: 9}]"};
  return with_edits(good, edits);
}

std::string interpolating(const std::string& eccentricities, const std::string& sub_intervals) {
  return of_interpolation({{2, "interpolation: {eccentricities: " + eccentricities +
                                   ", sub_intervals: " + sub_intervals + "}"},
                           {4, ""}});
}

std::string checking(const std::string& check) {
  return of_interpolation({{4, "check: [" + check + "]"}});
}

const std::vector<std::string> measuring{"study", "scenario.yaml", "--out", "out"};

/// Refused before anything is written.
class BadInterpolation : public testing::TestWithParam<ScenarioCase> {};
TEST_P(BadInterpolation, IsRefused) {
  const Marked marked = unmark(GetParam().text);
  Workspace(marked.text)
      .expect_refusal(measuring, {"scenario.yaml" + marked.place + ": ", GetParam().sentence});
}

const std::vector<ScenarioCase> wrong_interpolations{
    {"parabola", interpolating("[0.5, @1]", "[3]"), "is from 0 to below 1, and not 1"},
    {"negative_eccentricity", interpolating("[@-0.1]", "[3]"), "below 1, and not -0.1"},
    {"two_sub_intervals", interpolating("[0.5]", "[@2, 5]"),
     "a period has a whole number of sub-intervals from 3 to 1e6, and not 2"},
    {"half_a_sub_interval", interpolating("[0.5]", "[3, @3.5]"), "and not 3.5"},
    {"too_many_sub_intervals", interpolating("[0.5]", "[@2e6]"), "and not 2000000"},
    {"no_eccentricities", interpolating("@[]", "[3]"), "'eccentricities' must not be empty"},
    {"falling", interpolating("[0.5, @0.1]", "[3]"), "the numbers of 'eccentricities' must rise"},
    {"twice", interpolating("[0.5]", "[3, @3]"), "the numbers of 'sub_intervals' must rise"},
    {"number_for_list", interpolating("[0.5]", "@3"), "'sub_intervals' must be a list of numbers"},
    {"name", of_interpolation({{1, "name: @a/b"}}), "'a/b' cannot name a folder"},
    {"lacking", of_interpolation({{2, "interpolation: @{eccentricities: [0.5]}"}}),
     "section 'interpolation' lacks the key 'sub_intervals'"},
    {"unknown_key", of_interpolation({{3, "@outptu: {}"}}), "(did you mean 'output'?)"},
    {"unknown_path",
     checking("{path: @cubic_hermit, eccentricity: 0.5, sub_intervals: 5, error: 9}"),
     "(did you mean 'cubic_hermite'?)"},
    {"unknown_quantity",
     checking("{path: cubic_hermite, quantity: @speed, eccentricity: 0.5, sub_intervals: 5, "
              "error: 9}"),
     "there are: position, velocity"},
    {"other_eccentricity",
     checking("{path: cubic_hermite, eccentricity: @0.4, sub_intervals: 5, error: 9}"),
     "the study has no eccentricity 0.4"},
    {"other_sub_intervals",
     checking("{path: cubic_hermite, eccentricity: 0.5, sub_intervals: @4, error: 9}"),
     "the study has no division into 4 sub-intervals"},
    {"empty_check", checking("@{path: cubic_hermite, eccentricity: 0.5, sub_intervals: 5}"),
     "a check needs 'error', 'least_error' or both"},
    {"limits_swapped",
     checking("@{path: cubic_hermite, eccentricity: 0.5, sub_intervals: 5, error: 1, "
              "least_error: 2}"),
     "'least_error' must not lie above 'error'"},
    {"empty_check_of_differences", "name: t\ntable: matrices\ncheck: [@{scheme: usual}]\n",
     "a check needs 'error', 'least_error' or both"}};
INSTANTIATE_TEST_SUITE_P(Table, BadInterpolation, testing::ValuesIn(wrong_interpolations),
                         by_label);

/// Control: the good study passes.
TEST(GoodInterpolation, RunsWithoutAWord) {
  const Workspace workspace(of_interpolation({}));
  const Outcome outcome = workspace.mote(measuring);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

}  // namespace
}  // namespace mote::test
