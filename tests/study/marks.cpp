#include "mote/study/marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "study/written_study.hpp"

namespace mote::test {
namespace {

/// Two layouts, two operators, and more lines.
WrittenStudy study_with(const std::string& more) {
  return WrittenStudy(
      "name: marks\ndimension: 1\ndomain: {lower: [0], upper: [1]}\nfield: \"x\"\n"
      "layouts: [regular, geometric]\nresolutions: [10, 20]\nnorms: [l2, max]\n"
      "operators: [{name: A, family: mps}, {name: B, family: mps}]\n" +
      more);
}

StudyRow row(const std::string& layout, std::int64_t resolution, const std::string& name,
             double error, std::optional<double> order = {}, const std::string& norm = "l2") {
  return {layout, resolution, name, "gradient", norm, error, order};
}

/// The checks of a study that found these errors.
std::vector<CheckResult> checks(const std::string& more, std::vector<StudyRow> rows) {
  return study_checks(study_with(more).study, {.rows = std::move(rows)});
}

bool passes(const std::string& check, const StudyRow& found) {
  const auto results = checks("check: [{operator: A, layout: regular, " + check + "}]\n", {found});
  EXPECT_FALSE(results.empty());
  return std::ranges::all_of(results, &CheckResult::passed);
}

TEST(StudyCheck, HoldsErrorsBelowItsLimit) {
  EXPECT_TRUE(passes("error: 0.1", row("regular", 20, "A", 0.0999)));
  EXPECT_TRUE(passes("error: 0.1", row("regular", 20, "A", 0.1)));
  EXPECT_FALSE(passes("error: 0.1", row("regular", 20, "A", 0.1001)));
}

TEST(StudyCheck, HoldsOrdersFromBothSides) {
  const auto of_order = [](double order) { return row("regular", 20, "A", 0.1, order); };
  const std::string both = "least_order: 1.9, highest_order: 2.1";
  EXPECT_TRUE(passes(both, of_order(2)));
  EXPECT_FALSE(passes(both, of_order(1.89)));
  EXPECT_FALSE(passes(both, of_order(2.11)));
  EXPECT_TRUE(passes("least_order: 1.9", of_order(7)));
  EXPECT_TRUE(passes("highest_order: 2.1", of_order(-7)));
  EXPECT_FALSE(passes("least_order: -1", of_order(-1.5)));
}

TEST(StudyCheck, FailsWhereThereIsNoOrder) {
  EXPECT_FALSE(passes("least_order: -100", row("regular", 20, "A", 0.1)));
  EXPECT_FALSE(passes("highest_order: 100", row("regular", 20, "A", 0.1)));
}

TEST(StudyCheck, FailsAnErrorThatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(passes("error: 0.1", row("regular", 20, "A", nan)));
}

TEST(StudyCheck, JudgesTheHighestResolutionOfItsNorm) {
  const std::vector<StudyRow> rows{row("regular", 10, "A", 1), row("regular", 20, "A", 0.1),
                                   row("regular", 20, "A", 1, {}, "max")};
  const auto of = [&](const std::string& norm) {
    return checks("check: [{layout: regular, operator: A, error: 0.5, norm: " + norm + "}]\n",
                  rows);
  };
  ASSERT_EQ(of("l2").size(), 1u);
  EXPECT_TRUE(of("l2")[0].passed());
  ASSERT_EQ(of("max").size(), 1u);
  EXPECT_FALSE(of("max")[0].passed());
}

TEST(StudyCheck, IsForEachLayoutAndOperatorUnlessItNamesThem) {
  std::vector<StudyRow> rows;
  for (const char* layout : {"regular", "geometric"})
    for (const char* name : {"A", "B"}) rows.push_back(row(layout, 20, name, 0.1, 2));
  rows.back().error = 0.9;  // B on geometric
  const auto failures = [&](const std::string& which) {
    const auto results = checks("check: [{" + which + "error: 0.5, least_order: 1}]\n", rows);
    return std::pair(results.size(), std::ranges::count_if(results, [](const CheckResult& check) {
                       return !check.passed();
                     }));
  };
  EXPECT_EQ(failures(""), std::pair(std::size_t{8}, std::ptrdiff_t{1}));
  EXPECT_EQ(failures("layout: regular, "), std::pair(std::size_t{4}, std::ptrdiff_t{0}));
  EXPECT_EQ(failures("operator: B, "), std::pair(std::size_t{4}, std::ptrdiff_t{1}));
  EXPECT_EQ(failures("operator: A, layout: geometric, "),
            std::pair(std::size_t{2}, std::ptrdiff_t{0}));
}

const std::string marks =
    "marks:\n"
    "  norm: max\n"
    "  thresholds: [{quantity: gradient, good: 0.1, bad: 0.25}]\n"
    "  expected:\n"
    "    - {operator: A, quantity: gradient, marks: [good, bad]}\n"
    "    - {operator: B, quantity: gradient, marks: [not_good, good]}\n"
    "  exceptions: [{operator: B, layout: geometric, because: \"The print is wrong.\"}]\n";

/// Errors of A on regular and geometric, then of B.
std::vector<StudyRow> errors(double a, double b, double c, double d) {
  return {row("regular", 20, "A", a, {}, "max"), row("geometric", 20, "A", b, {}, "max"),
          row("regular", 20, "B", c, {}, "max"), row("geometric", 20, "B", d, {}, "max")};
}

std::vector<std::string> found(std::vector<StudyRow> rows) {
  std::vector<std::string> words;
  for (const auto& cell : marked_cells(study_with(marks).study, {.rows = std::move(rows)}))
    words.push_back(cell.found);
  return words;
}

TEST(StudyMarks, LieBetweenTheThresholds) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(found(errors(0.0999, 0.1, 0.25, 0.2501)),
            (Words{"good", "not_good", "not_good", "bad"}));
  EXPECT_EQ(found(errors(0, 1e9, 0.1001, 0.2499)), (Words{"good", "bad", "not_good", "not_good"}));
}

TEST(StudyMarks, AreComparedWithThePrint) {
  const auto cells = marked_cells(study_with(marks).study, {.rows = errors(0.05, 0.3, 0.2, 0.2)});
  ASSERT_EQ(cells.size(), 4u);
  EXPECT_TRUE(cells[0].agrees() && cells[1].agrees() && cells[2].agrees());
  EXPECT_FALSE(cells[3].agrees());
  EXPECT_EQ(cells[3].differential_operator, "B");
  EXPECT_EQ(cells[3].layout, "geometric");
  EXPECT_EQ(cells[3].expected, "good");
  EXPECT_EQ(cells[3].error, 0.2);
  EXPECT_EQ(cells[3].because, "The print is wrong.");
  EXPECT_EQ(cells[2].because, "");
}

TEST(StudyMarks, JudgeTheirOwnNorm) {
  auto rows = errors(0.05, 0.3, 0.2, 0.2);
  for (const StudyRow& max : errors(1, 1, 1, 1)) {
    rows.push_back(max);
    rows.back().norm = "l2";
  }
  EXPECT_EQ(found(rows), found(errors(0.05, 0.3, 0.2, 0.2)));
}

bool agree_at_least(int least, std::vector<StudyRow> rows) {
  const auto results =
      checks(marks + "  least_agreement: " + std::to_string(least) + "\n", std::move(rows));
  EXPECT_EQ(results.size(), 1u);
  return results.back().passed();
}

TEST(StudyMarks, AreCounted) {
  EXPECT_TRUE(agree_at_least(3, errors(0.05, 0.3, 0.2, 0.2)));
  EXPECT_FALSE(agree_at_least(4, errors(0.05, 0.3, 0.2, 0.2)));
  EXPECT_TRUE(agree_at_least(4, errors(0.05, 0.3, 0.2, 0.01)));
  EXPECT_TRUE(agree_at_least(0, errors(1, 0, 0, 1)));
  EXPECT_FALSE(agree_at_least(1, errors(1, 0, 0, 1)));
}

TEST(StudyMarks, AreNoCheckWithoutATable) { EXPECT_TRUE(checks("", errors(1, 1, 1, 1)).empty()); }

}  // namespace
}  // namespace mote::test
