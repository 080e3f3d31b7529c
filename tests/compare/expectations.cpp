// What a comparison must hold, met and missed.

#include "mote/compare/expectations.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "compare/members.hpp"
#include "mote/scenario/located_error.hpp"

namespace mote::test {
namespace {

using Expectation = ComparisonSection::Expectation;
using testing::HasSubstr;

const Paths vary{{"operator", {"a", "b"}}, {"particles.count", {"10", "20"}}};

/// Members: a 10, a 20, b 10, b 20. The error of a falls from 8 to 2, order 2; b breaks down.
struct Results {
  explicit Results(const Expectation& expectation)
      : made(comparison(vary, {expectation})),
        table(
            table_of(made, {passed(0, 8), passed(1, 2), broken(2, 1.5, "?"), broken(3, 1.2, "?")})),
        checks(expectation_results(table)) {}

  bool hold() const { return std::ranges::all_of(checks, &CheckResult::passed); }

  Comparison made;
  CompareTable table;
  std::vector<CheckResult> checks;
};

Expectation of(const std::string& name) { return {.select = {{"operator", {name}}}}; }

Expectation error_of(const std::string& name) {
  Expectation expectation = of(name);
  expectation.field = "velocity";
  return expectation;
}

Expectation failing(const std::string& name, double after, double before) {
  Expectation expectation = of(name);
  expectation.fails_after = after;
  expectation.fails_before = before;
  return expectation;
}

TEST(ExpectedFailure, MustComeInItsTime) {
  EXPECT_EQ(Results(failing("b", 1, 2)).checks.size(), 4u);
  EXPECT_TRUE(Results(failing("b", 1, 2)).hold());
  EXPECT_TRUE(Results(failing("b", 1.2, 1.5)).hold());
  EXPECT_FALSE(Results(failing("b", 1.3, 2)).hold()) << "one is too early";
  EXPECT_FALSE(Results(failing("b", 1, 1.4)).hold()) << "one is too late";
  EXPECT_FALSE(Results(failing("a", 1, 2)).hold()) << "these do not fail";
}

TEST(ExpectedFailure, MayHaveOneLimit) {
  Expectation at_all = of("b");
  at_all.fails_after = 0;
  EXPECT_TRUE(Results(at_all).hold());
  at_all.select = of("a").select;
  EXPECT_FALSE(Results(at_all).hold());
}

TEST(ExpectedFailure, IsNotOneByAnotherCause) {
  const Comparison made = comparison({{"operator", {"a"}}}, {failing("a", 0, 9)});
  const CompareTable table = table_of(made, {{.member = 0, .problem = "killed"}});
  EXPECT_FALSE(expectation_results(table)[0].passed());
}

TEST(ExpectedError, IsThatOfTheFinestMember) {
  Expectation error = error_of("a");
  error.error = 2;
  EXPECT_EQ(Results(error).checks.size(), 1u);
  EXPECT_TRUE(Results(error).hold());
  error.error = 1.9;
  EXPECT_FALSE(Results(error).hold());
  error.norm = "max";  // is 6
  error.error = 6;
  EXPECT_TRUE(Results(error).hold());
  error.error = 5.9;
  EXPECT_FALSE(Results(error).hold());
}

TEST(ExpectedError, IsMissedByAMemberThatFailed) {
  Expectation error = error_of("b");
  error.error = 1e9;
  EXPECT_FALSE(Results(error).hold());
}

TEST(ExpectedError, MayBeThatOfACoarserMember) {
  Expectation error = error_of("a");
  error.select.push_back({"particles.count", {"10"}});
  error.error = 8;
  EXPECT_TRUE(Results(error).hold());
  error.error = 7.9;
  EXPECT_FALSE(Results(error).hold());
}

TEST(ExpectedOrder, HasTwoSides) {
  Expectation order = error_of("a");
  order.least_order = 1.9;
  order.highest_order = 2.1;
  EXPECT_TRUE(Results(order).hold());
  order.least_order = 2.05;
  EXPECT_FALSE(Results(order).hold());
  order.least_order = 1;
  order.highest_order = 1.95;
  EXPECT_FALSE(Results(order).hold());
}

TEST(MembersPassed, ButThoseThatMustFail) {
  const auto all = {passed(0, 8), passed(1, 2), broken(2, 1.5, "?"), broken(3, 1.2, "?")};
  const Comparison foreseen = comparison(vary, {failing("b", 9, 10)});
  EXPECT_TRUE(members_passed(table_of(foreseen, all))) << "whatever the expectation says of time";
  const Comparison other = comparison(vary, {failing("a", 1, 2)});
  EXPECT_FALSE(members_passed(table_of(other, all)));
  EXPECT_FALSE(members_passed(table_of(foreseen, {passed(0, 8)}))) << "one has no row";
}

/// What is said against an expectation before anything runs; empty if nothing is.
std::string refusal(const Expectation& expectation, const Paths& varied = vary) {
  try {
    check_expectations(comparison(varied, {expectation}), Document());
  } catch (const LocatedError& error) {
    return error.what();
  }
  return "";
}

TEST(Expectation, IsRefusedWhereNoMemberCanMeetIt) {
  Expectation order = error_of("a"), elsewhere = error_of("a"), field = error_of("a");
  order.least_order = elsewhere.error = field.error = 1;
  EXPECT_EQ(refusal(order), "");
  EXPECT_THAT(refusal(order, {{"operator", {"a"}}}), HasSubstr("an order needs two values"));
  EXPECT_THAT(refusal(order, {{"operator", {"a"}}, {"particles.count", {"9"}}}),
              HasSubstr("an order needs two values"));
  elsewhere.select[0].values[0] = "c";
  EXPECT_THAT(refusal(elsewhere), HasSubstr("no member has operator = c"));
  elsewhere.select[0].path = "operatr";
  EXPECT_THAT(refusal(elsewhere), HasSubstr("'operatr' is not varied (did you mean 'operator'?)"));
  field.field = "velocty";
  EXPECT_THAT(refusal(field), HasSubstr("(did you mean 'velocity'?)"));
}

}  // namespace
}  // namespace mote::test
