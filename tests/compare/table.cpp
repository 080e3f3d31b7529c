// Rows, observed orders, and the table in its three forms.

#include <gmock/gmock.h>

#include "compare/members.hpp"
#include "mote/compare/compare_report.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::HasSubstr;
using testing::Not;

const Paths two_by_three{{"particles.count", {"40", "10", "20"}}, {"operator", {"a", "b,c"}}};

const Norm& l2 = norm_named("l2");

TEST(Order, IsBetweenAMemberAndTheNextCoarserOfTheSameFamily) {
  const Comparison made = comparison(two_by_three);
  // Members: 40 a, 40 b, 10 a, 10 b, 20 a, 20 b. Of a the error falls by 4 and 8, of b not at all.
  const CompareTable table = table_of(
      made, {passed(2, 32), passed(4, 8), passed(0, 1), passed(1, 7), passed(3, 7), passed(5, 7)});
  EXPECT_NEAR(*table.order(*table.of(4), "velocity", l2), 2, 1e-14);
  EXPECT_NEAR(*table.order(*table.of(0), "velocity", l2), 3, 1e-14);
  EXPECT_NEAR(*table.order(*table.of(1), "velocity", l2), 0, 1e-14);
  EXPECT_EQ(table.order(*table.of(2), "velocity", l2), std::nullopt) << "the coarsest";
  EXPECT_EQ(table.order(*table.of(0), "pressure", l2), std::nullopt) << "no such error";
}

TEST(Order, IsNotKnownBesideAFailureOrAnErrorOfZero) {
  const Comparison made = comparison({{"particles.count", {"10", "20", "40", "80"}}});
  const CompareTable table =
      table_of(made, {passed(0, 4), broken(1, 1, "?"), passed(2, 1), passed(3, 0)});
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(table.order(*table.of(k), "velocity", l2), std::nullopt) << k;
}

TEST(Order, IsNotObservedAlongOtherKeys) {
  const Comparison made = comparison({{"operator.smoothing_length", {"1", "2"}}});
  const CompareTable table = table_of(made, {passed(0, 4), passed(1, 1)});
  EXPECT_EQ(table.order(*table.of(1), "velocity", l2), std::nullopt);
}

TEST(CompareCsv, HasEveryColumnAndEmptyCellsWithoutAValue) {
  const Comparison made = comparison({{"particles.count", {"10", "20"}}, {"o", {"a", "b,\"c"}}});
  const CompareTable table = table_of(
      made,
      {passed(0, 4), broken(1, 1.5, "x, \"y\""), passed(2, 1), {.member = 3, .problem = "p"}});
  EXPECT_EQ(compare_csv(table),
            "particles.count,o,time,particles,steps,velocity_l1,velocity_l1_order,velocity_l2,"
            "velocity_l2_order,velocity_max,velocity_max_order,evaluations,wall_seconds,"
            "particle_updates_per_second,mass_drift,energy_drift,passed,failure,folder\n"
            "10,a,3,41,10,8,,4,,12,,0,0.5,820,0,-0.10000000000000001,true,,runs/01-10-a\n"
            "10,\"b,\"\"c\",1.5,41,4,,,,,,,0,0,0,,,false,\"x, \"\"y\"\"\",runs/02-10-b_c\n"
            "20,a,3,41,10,2,2,1,2,3,2,0,0.5,820,0,-0.10000000000000001,true,,runs/03-20-a\n"
            "20,\"b,\"\"c\",,,,,,,,,,,,,,,false,p,runs/04-20-b_c\n");
}

TEST(CompareCsv, HasTheRowsThatAreThereInTheOrderOfTheMembers) {
  const Comparison made = comparison({{"o", {"a", "b", "c"}}});
  const std::string text = compare_csv(table_of(made, {passed(2, 1), passed(0, 1)}));
  EXPECT_LT(text.find("\na,"), text.find("\nc,"));
  EXPECT_THAT(text, Not(HasSubstr("\nb,")));
}

TEST(Verdict, SaysWhatBecameOfAMember) {
  EXPECT_EQ(verdict(passed(0, 1)), "passed");
  Row unchecked = passed(0, 1);
  unchecked.is_checked = false;
  EXPECT_EQ(verdict(unchecked), "ran");
  EXPECT_EQ(verdict(broken(0, 1.25,
                           "step 4, t = 1.25: particles 1 and 2 crossed at x = 2.5. Likely "
                           "cause: a: b. Particles there: 1")),
            "failed at t = 1.25: particles 1 and 2 crossed at x = 2.5");
  EXPECT_EQ(verdict({.problem = "killed by signal 9 (Killed)"}),
            "no result: killed by signal 9 (Killed)");
  Row failed = passed(0, 1);
  failed.passed = false;
  failed.failed_checks = {"mass drift"};
  EXPECT_EQ(verdict(failed), "check failed: mass drift");
}

TEST(CompareReport, ShowsFailuresAndWhatIsBetweenBars) {
  const Comparison made = comparison({{"o", {"a|b", "c"}}});
  const CompareTable table =
      table_of(made, {passed(0, 4), broken(1, 1.5, "step 1, t = 1.5: gone")});
  const std::string text = compare_markdown(table, {2, 3}, "compare.png");
  EXPECT_THAT(text, HasSubstr("2 runs of one scenario, with `o` over 2 values. **1 of 2 runs did "
                              "not pass.**"));
  EXPECT_THAT(text, HasSubstr("](compare.png)"));
  EXPECT_THAT(text, HasSubstr("at the end against `sheets`."));
  EXPECT_THAT(text, HasSubstr("\n| `a\\|b` | 4.00e+00 | 0.5 | 0.0e+00 | -1.0e-01 | passed |\n"));
  EXPECT_THAT(text, HasSubstr("\n| `c` | – | 0 | – | – | **failed at t = 1.5: gone** |\n"));
  EXPECT_THAT(text, HasSubstr("Up to 2 runs were made beside each other, on 3 threads each."));
  EXPECT_THAT(compare_markdown(table, {1, 1}, ""), Not(HasSubstr("png")));
}

TEST(CompareText, HasColumnsOfOneWidth) {
  const Comparison made = comparison({{"operator", {"sph.gauss", "mps"}}});
  EXPECT_EQ(compare_text(table_of(made, {passed(0, 4), broken(1, 1.5, "gone")})),
            "operator   velocity L2  wall s  mass drift  energy drift  verdict\n"
            "sph.gauss  4.00e+00     0.5     0.0e+00     -1.0e-01      passed\n"
            "mps        –            0       –           –             failed at t = 1.5: gone\n");
}

TEST(CompareText, HasWhatRunsCostAndVectorsAsOneColumn) {
  const Comparison made = comparison({{"time.integrator", {"a", "b", "c"}}});
  Row row = passed(0, 4);
  row.run->pair_work.evaluations = 42;
  row.run->conservation = {{"momentum_x", 0, 0, 1e-9}, {"momentum_y", 0, 0, -2e-9}};
  Row other = passed(1, 2);
  other.run->conservation = {{"momentum_x", 0, 0, 3e-9}};
  EXPECT_EQ(compare_text(table_of(made, {row, other, {.member = 2, .problem = "unsuited"}})),
            "time.integrator  velocity L2  steps  evaluations  wall s  momentum drift  verdict\n"
            "a                4.00e+00     10     42           0.5     -2.0e-09        passed\n"
            "b                2.00e+00     10     0            0.5     3.0e-09         passed\n"
            "c                –            –      –            –       –               "
            "no result: unsuited\n");
}

TEST(Row, ReadsTheCertificateOfARun) {
  const TemporaryFolder folder;
  Certificate run = *passed(0, 2).run;
  run.steps_timed = 10;
  run.pair_work.evaluations = 30;
  run.checks = {{"good", 1, 2}, {"bad", 3, 2}};
  write(folder / "summary.json", summary_json(run));
  const Row row = row_of(7, folder.path(), "");
  EXPECT_EQ(row.member, 7u);
  EXPECT_FALSE(row.passed);
  EXPECT_THAT(row.failed_checks, testing::ElementsAre("bad"));
  EXPECT_EQ(row.error("velocity")->max, 6);
  EXPECT_EQ(row.run->pair_work.evaluations, 30);
  EXPECT_DOUBLE_EQ(row.updates_per_second, 820);
  EXPECT_DOUBLE_EQ(*row.drift("energy"), -0.1);
  EXPECT_FALSE(row.drift("momentum"));
  EXPECT_EQ(row_of(7, folder.path(), "killed").failure(), "killed");
}

TEST(Row, TellsOfABrokenRun) {
  const TemporaryFolder folder;
  write(folder / "summary.json", summary_json(*broken(0, 1.5, "gone").run));
  const Row row = row_of(0, folder.path(), "");
  EXPECT_TRUE(row.broke_down());
  EXPECT_FALSE(row.passed);
  EXPECT_EQ(row.run->time, 1.5);
  EXPECT_EQ(row.failure(), "gone");
}

TEST(Row, TellsOfACertificateThatIsMissingOrCutShort) {
  const TemporaryFolder folder;
  EXPECT_THAT(row_of(0, folder.path(), "").failure(), HasSubstr("no summary.json"));
  for (const char* text : {"", "{\"name\": \"a\"", "[]", "{}", "{\"particles\": \"x\"}"}) {
    write(folder / "summary.json", text);
    const Row row = row_of(0, folder.path(), "");
    EXPECT_THAT(row.failure(), HasSubstr("no summary.json")) << text;
    EXPECT_FALSE(row.run || row.passed) << text;
  }
}

}  // namespace
}  // namespace mote::test
