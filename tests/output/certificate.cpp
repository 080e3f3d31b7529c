#include "mote/output/certificate.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace mote {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ErrorNorms, AreRelativeToTheReference) {
  const std::vector<double> values{1, 2, 3}, reference{1, 1, 5};
  const ErrorNorms error = error_norms("f", values, reference);
  EXPECT_DOUBLE_EQ(error.l1, 3.0 / 7);
  EXPECT_DOUBLE_EQ(error.l2, std::sqrt(5.0 / 27));
  EXPECT_DOUBLE_EQ(error.max, 2.0 / 5);
  EXPECT_EQ(error.compared, 3);
}

TEST(ErrorNorms, AreAbsoluteWhereTheReferenceIsZero) {
  const std::vector<double> values{3, 4}, reference{0, 0};
  EXPECT_DOUBLE_EQ(error_norms("f", values, reference).l2, 5);
}

TEST(ErrorNorms, LeaveOutAndCountWhatHasNoReference) {
  const std::vector<double> values{3, 4}, reference{NAN, 4};
  const ErrorNorms error = error_norms("f", values, reference);
  EXPECT_EQ(error.l2, 0);
  EXPECT_EQ(error.compared, 1);
}

TEST(ErrorNorms, OfWhatIsNotANumberIsNotANumber) {
  const std::vector<double> values{NAN, 4}, reference{3, 4};
  EXPECT_TRUE(std::isnan(error_norms("f", values, reference).l2));
}

TEST(ErrorNorms, OfVectorsAreOfTheirLengths) {
  const std::vector<double> values{3, 4, 1, 1}, reference{0, 0, 1, 0};
  const ErrorNorms error = error_norms("f", values, reference, 2);
  EXPECT_DOUBLE_EQ(error.l1, 6);
  EXPECT_DOUBLE_EQ(error.l2, std::sqrt(26));
  EXPECT_DOUBLE_EQ(error.max, 5);
  EXPECT_EQ(error.compared, 2);
}

TEST(ErrorNorms, OfVectorsLeaveOutThoseWithAComponentThatHasNoReference) {
  const std::vector<double> values{3, 4, 1, 1}, reference{0, NAN, 1, 0};
  EXPECT_EQ(error_norms("f", values, reference, 2).compared, 1);
  EXPECT_EQ(error_norms("f", values, reference).compared, 3);
}

TEST(Drifts, AreRelativeToTheScale) {
  const auto result =
      drifts({{"mass", 2, 2}, {"momentum", 0, 0}}, {{"mass", 3, 3}, {"momentum", 1, 4}});
  EXPECT_DOUBLE_EQ(result[0].drift, 1.0 / 3);
  EXPECT_DOUBLE_EQ(result[1].drift, 0.25);
}

TEST(CheckResult, OfWhatIsNotANumberFails) {
  EXPECT_TRUE((CheckResult{"a", 1, 1}.passed()));
  EXPECT_FALSE((CheckResult{"a", 1.1, 1}.passed()));
  EXPECT_FALSE((CheckResult{"a", NAN, 1}.passed()));
}

/// The words of the only check of a terminal's text.
std::string words(const CheckResult& check) { return checks_text({check}); }

TEST(CheckResult, IsWordedWithAsManyDigitsAsTellItFromItsLimit) {
  using enum CheckResult::Sense;
  EXPECT_THAT(words({"a", 0.5, 1}), HasSubstr(" 0.5        at most 1 "));
  EXPECT_THAT(words({"a", 7.1396e-05, 7.14e-05}), HasSubstr(" 7.1396e-05 at most 7.14e-05 "));
  EXPECT_THAT(words({"a", 7.1404e-05, 7.14e-05, at_least}),
              HasSubstr(" 7.1404e-05 at least 7.14e"));
  EXPECT_THAT(words({"a", std::nextafter(1, 2), 1}), HasSubstr(" 1.0000000000000002 at most 1 "));
  EXPECT_THAT(words({"a", 1.0 / 3, 1.0 / 3}), HasSubstr(" 0.333      at most 0.333 "));
  EXPECT_THAT(checks_markdown({{"a", 7.1396e-05, 7.14e-05}}),
              HasSubstr("| a | 7.1396e-05 | at most 7.14e-05 | passed |"));
}

TEST(Certificate, HasNoSignBeforeWhatIsNotANumber) {
  Certificate certificate;
  certificate.errors = {{"position", -NAN, -NAN, -NAN, 1}};
  certificate.conservation = {{"mass", -NAN, 1, -NAN}};
  certificate.checks = {{"position relative L2 error", -NAN, 1}};
  const std::string report = report_markdown(certificate, "") + checks_text(certificate.checks);
  EXPECT_THAT(report, HasSubstr("| position | nan | nan | nan |"));
  EXPECT_THAT(report, HasSubstr("| mass | nan | 1 | nan |"));
  EXPECT_THAT(report, Not(HasSubstr("-nan")));
}

TEST(Certificate, PassesOnlyIfEveryCheckDoesAndNothingFailed) {
  Certificate certificate;
  certificate.checks = {{"a", 0.5, 1}};
  EXPECT_TRUE(certificate.passed());
  certificate.checks.push_back({"b", 2, 1});
  EXPECT_FALSE(certificate.passed());
  certificate.checks.pop_back();
  certificate.failure = "step 3: broken";
  EXPECT_FALSE(certificate.passed());
  EXPECT_THAT(report_markdown(certificate, ""), HasSubstr("step 3: broken"));
  EXPECT_EQ(nlohmann::json::parse(summary_json(certificate))["passed"], false);
}

TEST(Certificate, TellsTheMemoryAParticleWhereItIsKnown) {
  Certificate certificate;
  EXPECT_FALSE(nlohmann::json::parse(summary_json(certificate)).contains("bytes_per_particle"));
  certificate.bytes_per_particle = 512;
  EXPECT_EQ(nlohmann::json::parse(summary_json(certificate))["bytes_per_particle"], 512);
  EXPECT_THAT(report_markdown(certificate, ""), HasSubstr("512 bytes of memory a particle"));
}

}  // namespace
}  // namespace mote
