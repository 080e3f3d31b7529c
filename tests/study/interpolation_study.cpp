#include "mote/study/interpolation_study.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mote/scenario/located_error.hpp"
#include "study/csv_table.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::HasSubstr;

InterpolationStudy study_of(const std::string& more, const std::string& sub_intervals = "[5, 8]") {
  const TemporaryFolder folder;
  const auto path =
      write(folder / "study.yaml",
            "{name: t, interpolation: {eccentricities: [0, 0.2], sub_intervals: " + sub_intervals +
                "}, " + more + "}");
  return read_interpolation_study(Document::from_file(path.string()));
}

TEST(InterpolationStudy, HasEveryOrbitOnce) {
  const InterpolationStudy study = study_of("");
  const InterpolationTable table = evaluated(study);
  ASSERT_EQ(table.size(), 4u);
  for (std::size_t k = 0; k < table.size(); ++k) {
    EXPECT_EQ(table[k].sub_intervals, study.sub_intervals[k / 2]);
    EXPECT_EQ(table[k].eccentricity, study.eccentricities[k % 2]);
    const auto errors = kepler_interpolation_errors(table[k].eccentricity, table[k].sub_intervals);
    for (std::size_t path = 0; path < errors.size(); ++path) {
      EXPECT_EQ(table[k].errors[path].position, errors[path].position);
      EXPECT_EQ(table[k].errors[path].velocity, errors[path].velocity);
    }
  }
}

/// Between e^(-ih/2) and e^(ih/2) the cubic has cos(h/2) + h/4 sin(h/2) in the middle in place
/// of 1.
TEST(InterpolationStudy, HasTheErrorOfACircle) {
  const auto table = evaluated(study_of(""));
  for (const InterpolationRow& row : {table[0], table[2]}) {
    ASSERT_EQ(row.eccentricity, 0);
    const double h = 2 * std::numbers::pi / row.sub_intervals;
    const double error = 1 - std::cos(h / 2) - h / 4 * std::sin(h / 2);
    EXPECT_NEAR(row.errors[0].position, error, 1e-15);
  }
}

/// One error, judged with limits on both sides of it, and on each side alone.
TEST(InterpolationStudy, ChecksTheErrorThatItNames) {
  const auto check = [](const std::string& path, const std::string& quantity, double error,
                        double least_error) {
    const InterpolationStudy study = study_of(
        fmt::format("check: [{{path: {}, quantity: {}, eccentricity: 0.2, sub_intervals: 8, "
                    "error: {}, least_error: {}}}]",
                    path, quantity, error, least_error));
    const auto checks = table_checks(study, evaluated(study));
    EXPECT_EQ(checks.size(), 2u);
    return std::pair(checks[0].passed(), checks[1].passed());
  };
  const auto errors = kepler_interpolation_errors(0.2, 8);
  const auto paths = path_choices();
  ASSERT_EQ(paths.size(), errors.size());
  for (std::size_t k = 0; k < paths.size(); ++k)
    for (const bool of_position : {true, false}) {
      const double error = of_position ? errors[k].position : errors[k].velocity;
      const std::string quantity = of_position ? "position" : "velocity";
      const auto within = [&](double upper, double lower) {
        return check(paths[k].name, quantity, upper * error, lower * error);
      };
      EXPECT_EQ(within(1.01, 0.99), std::pair(true, true)) << paths[k].name << ' ' << quantity;
      EXPECT_EQ(within(0.99, 0.98), std::pair(false, true)) << paths[k].name << ' ' << quantity;
      EXPECT_EQ(within(1.02, 1.01), std::pair(true, false)) << paths[k].name << ' ' << quantity;
    }
}

TEST(InterpolationStudy, IsWrittenForPeopleAndPrograms) {
  const InterpolationStudy study = study_of("");
  const InterpolationTable table = evaluated(study);
  const CsvTable csv(table_csv(table));
  EXPECT_EQ(csv.names, (std::vector<std::string>{"sub_intervals", "eccentricity", "path",
                                                 "position", "velocity"}));
  ASSERT_EQ(csv.rows.size(), 4u * 4);
  const auto cubic = csv.where({{"sub_intervals", "8"}, {"path", "cubic_hermite"}});
  EXPECT_THAT(numbers(cubic, "position"),
              testing::ElementsAre(table[2].errors[0].position, table[3].errors[0].position));
  EXPECT_THAT(numbers(cubic, "velocity"),
              testing::ElementsAre(table[2].errors[0].velocity, table[3].errors[0].velocity));
  const std::string report = table_markdown(study, table, {"errors.png"});
  EXPECT_THAT(report, HasSubstr("![errors.png](errors.png)"));
  EXPECT_THAT(report, HasSubstr("## 5 sub-intervals\n\n| eccentricity | cubic_hermite | "));
  EXPECT_THAT(report, HasSubstr("## 8 sub-intervals\n\n| eccentricity | cubic_hermite | "));
}

TEST(InterpolationStudy, ReadsWhatItWrites) {
  InterpolationStudy study = study_of(
      "output: {picture: false}, check: [{path: two_step_hermite, eccentricity: 0.2, "
      "sub_intervals: 5, least_error: 1.0e-3}]");
  EXPECT_FALSE(study.picture);
  const std::string written = resolved_yaml(study);
  const TemporaryFolder folder;
  InterpolationStudy again =
      read_interpolation_study(Document::from_file(write(folder / "study.yaml", written).string()));
  EXPECT_EQ(resolved_yaml(again), written);
  EXPECT_EQ(again.sub_intervals, study.sub_intervals);
  EXPECT_EQ(again.checks[0].quantity, "position");
}

}  // namespace
}  // namespace mote::test
