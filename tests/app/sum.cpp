#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "study/csv_table.hpp"
#include "support/program.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using Names = std::vector<std::string>;

/// A file with these columns, and random numbers in [0, 1).
std::string points(const std::string& columns, int count, std::uint64_t seed = 1) {
  Draws draws(seed);
  std::string text = columns + "\n";
  for (int i = 0; i < count; ++i)
    for (std::ptrdiff_t c = std::ranges::count(columns, ','); c >= 0; --c)
      text += std::to_string(draws.uniform(0, 1)) + (c > 0 ? "," : "\n");
  return text;
}

/// A folder in which points are summed.
struct Place : TemporaryFolder {
  Outcome sum(const std::string& file, const std::string& kernel, const Names& more = {}) const {
    Names arguments{"sum",   (*this / file).string(),     "--kernel", kernel,
                    "--out", (*this / "out.csv").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mote(arguments);
  }
  CsvTable result() const { return CsvTable(read(*this / "out.csv")); }
};

std::vector<double> column(const CsvTable& table, const std::string& name) {
  return numbers(table.rows, name);
}

TEST(Sum, OfCauchyIsThatOfItsPairs) {
  const Place place;
  write(place / "p.csv", "strength_re,x,strength_im,y\n1,0,0,0\n0,3,2,4\n");
  ASSERT_EQ(place.sum("p.csv", "cauchy").exit_code, 0);
  const CsvTable result = place.result();
  EXPECT_EQ(result.names, (Names{"x", "y", "value_re", "value_im"}));
  // 2 i/(0 - (3 + 4 i)) and 1/(3 + 4 i)
  EXPECT_THAT(column(result, "value_re"),
              testing::Pointwise(testing::DoubleNear(1e-15), {-8.0 / 25, 3.0 / 25}));
  EXPECT_THAT(column(result, "value_im"),
              testing::Pointwise(testing::DoubleNear(1e-15), {-6.0 / 25, -4.0 / 25}));
}

TEST(Sum, OfGravityIsThatOfItsPairs) {
  const Place place;
  write(place / "p.csv", "x,y,z,mass\n0,0,0,3\n0,0,2,5\n");
  ASSERT_EQ(place.sum("p.csv", "gravity").exit_code, 0);
  const CsvTable result = place.result();
  EXPECT_EQ(result.names,
            (Names{"x", "y", "z", "potential", "gradient_x", "gradient_y", "gradient_z"}));
  EXPECT_THAT(column(result, "potential"),
              testing::Pointwise(testing::DoubleNear(1e-15), {-2.5, -1.5}));
  EXPECT_THAT(column(result, "gradient_z"),
              testing::Pointwise(testing::DoubleNear(1e-15), {-1.25, 0.75}));
}

TEST(Sum, OfVorticesIsTheirVelocityWithItsGradient) {
  const Place place;
  write(place / "p.csv", "x,y,circulation\n0,0,1\n");
  write(place / "t.csv", "x,y\n2,0\n0,-1\n");
  const Names at_targets{"--targets", (place / "t.csv").string(), "--gradient"};
  ASSERT_EQ(place.sum("p.csv", "biot_savart", at_targets).exit_code, 0);
  const CsvTable result = place.result();
  EXPECT_EQ(result.names,
            (Names{"x", "y", "velocity_x", "velocity_y", "velocity_gradient_xx",
                   "velocity_gradient_xy", "velocity_gradient_yx", "velocity_gradient_yy"}));
  const double one = 1 / (2 * std::numbers::pi);
  const auto near = [](const std::vector<double>& values) {
    return testing::Pointwise(testing::DoubleNear(1e-15), values);
  };
  EXPECT_THAT(column(result, "velocity_x"), near({0, one}));
  EXPECT_THAT(column(result, "velocity_y"), near({one / 2, 0}));
  // u_y = x/r^2 falls as -1/r^2 along x; u_x = -y/r^2 is as steep across.
  EXPECT_THAT(column(result, "velocity_gradient_yx"), near({-one / 4, one}));
  EXPECT_THAT(column(result, "velocity_gradient_xy"), near({-one / 4, one}));
  EXPECT_THAT(column(result, "velocity_gradient_xx"), near({0, 0}));
}

/// Every kernel in every dimension, for points and blobs, at the sources and elsewhere.
TEST(Sum, AgreesWithTheSumOfItsVerification) {
  const Place place;
  write(place / "plane.csv", points("x,y,mass,circulation,strength_re,strength_im", 300));
  write(place / "space.csv", points("x,y,z,mass,circulation_x,circulation_y,circulation_z", 300));
  write(place / "plane_targets.csv", points("x,y", 250, 2));
  write(place / "space_targets.csv", points("x,y,z", 250, 2));
  for (const std::string space : {"plane", "space"})
    for (const std::string kernel : {"cauchy", "gravity", "biot_savart"})
      for (const std::string core : {"point", "gauss", "algebraic.4"})
        for (const bool at_sources : {true, false}) {
          if (kernel == "cauchy" && (space == "space" || core != "point")) continue;
          Names more{"--method", "direct", "--tolerance", "1e-13", "--verify", "--overwrite"};
          if (core != "point") more.insert(more.end(), {"--core", core, "--core-size", "0.02"});
          if (kernel == "biot_savart") more.emplace_back("--gradient");
          if (!at_sources)
            more.insert(more.end(), {"--targets", (place / (space + "_targets.csv")).string()});
          const Outcome outcome = place.sum(space + ".csv", kernel, more);
          EXPECT_EQ(outcome.exit_code, 0)
              << space << " " << kernel << " " << core << " " << at_sources << "\n"
              << outcome.errors << outcome.output;
          EXPECT_THAT(outcome.output, HasSubstr(": passed\n"));
        }
}

TEST(Sum, SaysWhatItDid) {
  const Place place;
  write(place / "p.csv", points("x,y,mass", 300));
  const Outcome outcome = place.sum("p.csv", "gravity", {"--tolerance", "1e-6", "--verify"});
  EXPECT_THAT(outcome.output,
              HasSubstr("gravity in 2D: 300 sources, 300 targets, method multipole, tolerance "
                        "1e-06\n"));
  EXPECT_THAT(outcome.output, HasSubstr(" million points a second\n"));
  EXPECT_THAT(outcome.output, HasSubstr("of the largest value, at 200 targets: passed\n"));
  EXPECT_THAT(outcome.output, HasSubstr("result:  " + (place / "out.csv").string()));
  EXPECT_THAT(place.sum("p.csv", "gravity", {"--quiet", "--verify", "--overwrite"}).output,
              IsEmpty());
}

/// The control: from afar two opposite strengths cancel but for fewer digits than are asked for.
TEST(Sum, FailsItsVerificationAboveTheTolerance) {
  const Place place;
  write(place / "p.csv", "x,y,strength\n0.1,0,1\n-0.1,0,-1\n");
  write(place / "t.csv", "x,y\n1e9,3\n-1e9,7\n");
  const Outcome outcome = place.sum("p.csv", "cauchy",
                                    {"--method", "direct", "--targets", (place / "t.csv").string(),
                                     "--tolerance", "1e-12", "--verify"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("FAILED, above the tolerance\n"));
  EXPECT_EQ(place.result().rows.size(), 2u);
}

TEST(Sum, TakesTheGeneralNameOfStrengths) {
  const Place place;
  write(place / "mass.csv", points("x,y,mass", 20));
  write(place / "strength.csv", points("x,y,strength", 20));
  ASSERT_EQ(place.sum("mass.csv", "gravity").exit_code, 0);
  const std::string by_name = read(place / "out.csv");
  ASSERT_EQ(place.sum("strength.csv", "gravity", {"--overwrite"}).exit_code, 0);
  EXPECT_EQ(read(place / "out.csv"), by_name);
}

TEST(Sum, KeepsTheOrderAndThePlacesOfThePoints) {
  const Place place;
  write(place / "p.csv", points("x,y,strength", 500));
  ASSERT_EQ(place.sum("p.csv", "cauchy").exit_code, 0);
  const CsvTable given(read(place / "p.csv")), result = place.result();
  EXPECT_EQ(column(result, "x"), column(given, "x"));
  EXPECT_EQ(column(result, "y"), column(given, "y"));
}

TEST(Sum, ReplacesAFileOnlyIfAsked) {
  const Place place;
  write(place / "p.csv", points("x,y,strength", 20));
  write(place / "out.csv", "mine");
  EXPECT_EQ(place.sum("p.csv", "cauchy").exit_code, 2);
  EXPECT_EQ(read(place / "out.csv"), "mine");
  EXPECT_EQ(place.sum("p.csv", "cauchy", {"--overwrite"}).exit_code, 0);
  EXPECT_EQ(place.result().rows.size(), 20u);
  EXPECT_FALSE(fs::exists(place / "out.csv.part"));
}

TEST(Sum, IsTheSameAtAnyNumberOfThreads) {
  const Place place;
  write(place / "plane.csv", points("x,y,mass,strength", 9000));
  for (const std::string kernel : {"cauchy", "gravity"}) {
    std::string one;
    for (const char* threads : {"1", "2", "4"}) {
      ASSERT_EQ(place.sum("plane.csv", kernel, {"--threads", threads, "--overwrite"}).exit_code, 0);
      if (one.empty()) one = read(place / "out.csv");
      EXPECT_TRUE(read(place / "out.csv") == one) << kernel << ", " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace mote::test
