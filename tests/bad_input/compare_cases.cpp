// mote compare: what is varied, which members there cannot be, and what they must hold.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

using Words = std::vector<std::string>;

Words comparing(const Words& variations, const Words& more = {}) {
  Words arguments{"compare", "scenario.yaml", "--out", "out"};
  for (const std::string& variation : variations)
    arguments.insert(arguments.end(), {"--vary", variation});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

CommandCase varying(const std::string& label, const std::string& variation,
                    const std::string& sentence) {
  return {label, comparing({variation}), "--vary " + variation + ": ", sentence};
}

std::string numbers_to(int last) {
  std::string text = "1";
  for (int k = 2; k <= last; ++k) text.append(",").append(std::to_string(k));
  return text;
}

class BadComparison : public testing::TestWithParam<CommandCase> {};
TEST_P(BadComparison, IsRefused) {
  const Workspace workspace;
  GetParam().prepare(workspace);
  workspace.expect_refusal(GetParam().arguments, {GetParam().beginning, GetParam().sentence});
}

const std::vector<CommandCase> bad_variations{
    {"nothing_varied", comparing({}), "scenario.yaml: ", "nothing is varied"},
    {"without_anything", comparing({}, {"--vary"}), "mote: --vary: ", "missing"},
    varying("without_equals_sign", "particles.count", "must have the form key.path=value"),
    varying("without_path", "=3", "must have the form key.path=value"),
    varying("without_values", "particles.count=", "'particles.count' has no values"),
    varying("without_one_value", "particles.count=21,,41", "nothing is given"),
    varying("unknown_key", "partcles.count=21,41", "(did you mean 'particles'?)"),
    varying("unknown_nested_key", "particles.cuont=21", "(did you mean 'count'?)"),
    varying("one_of_wrong_type", "particles.count=41,abc", "(in the member particles.count = abc)"),
    varying("one_unknown_word", "operator=mps,sph.gaus", "(did you mean 'gauss'?)"),
    varying("a_value_twice", "particles.count=41,21,41", "has the value 41 twice"),
    varying("bracket_open", "operator=[mps", "this is not YAML"),
    varying("bracket_closed_too_soon", "operator=mps], [sph.gauss", "a second YAML document"),
    varying("step_beyond_the_limit", "time.step=0.01,8", "beyond the stability limit"),
    varying("impossible_option", "operator=mps,vortex_blob.gauss", "needs points with circulation"),
    varying("end_beyond_the_exact_solution", "time.end=1,30", "(in the member time.end = 30)"),
    varying("threads", "threads=1,2", "'threads' cannot be varied"),
    varying("picture", "output.picture=true,false", "'output.picture' cannot be varied"),
    varying("itself", "compare.vary=[1]", "'compare.vary' cannot be varied"),
    {"too_many_members", comparing({"particles.seed=" + numbers_to(1001)}),
     "mote: ", "at most 1000 members, and this has 1001"},
    {"a_key_twice", comparing({"particles.count=41", "particles.count=42"}),
     "--vary particles.count=42: ", "'particles.count' is varied twice"},
    {"set_and_varied", comparing({"particles.count=41"}, {"--set", "particles.count=5"}),
     "--set particles.count=5: ", "'particles.count' is varied, so this would have no effect"},
    {"set_within_a_varied_section", comparing({"operator=mps"}, {"--set", "operator.kernel=lucy"}),
     "--set operator.kernel=lucy: ", "'operator' is varied"},
    {"jobs_0", comparing({"operator=mps"}, {"--jobs", "0"}), "mote: --jobs: ", "0"},
    {"options_of_one_member_only", comparing({"operator=mps,sph.lucy", "operator.kernel=gauss"}),
     "--vary operator.kernel=gauss: ", "(in the member operator = mps, operator.kernel = gauss)"}};
INSTANTIATE_TEST_SUITE_P(Vary, BadComparison, testing::ValuesIn(bad_variations), by_label);

const auto with_former_output = [](const Workspace& workspace) {
  fs::create_directory(workspace / "out");
  write(workspace / "out/compare.yaml", "# The comparison as it was run.\n");
  write(workspace / "out/compare.csv", "former");
};

const std::vector<CommandCase> bad_folders{
    {"not_empty", comparing({"operator=mps"}),
     "mote: out: ", "--overwrite replaces a former comparison", with_former_output},
    {"kept_when_a_member_is_bad", comparing({"operator=mps,sph.gaus"}, {"--overwrite"}),
     "--vary operator=mps,sph.gaus: ", "unknown kernel", with_former_output},
    {"of_somebody_else", comparing({"operator=mps"}, {"--overwrite"}),
     "mote: out: ", "not the output of a comparison", [](const Workspace& workspace) {
       fs::create_directory(workspace / "out");
       write(workspace / "out/mine", "mine");
     }}};
INSTANTIATE_TEST_SUITE_P(Folder, BadComparison, testing::ValuesIn(bad_folders), by_label);

/// A scenario with the section `compare`, in one line after all others.
ScenarioCase section(const std::string& label, const std::string& text,
                     const std::string& sentence) {
  return {label, lines({}) + "compare: " + text + "\n", sentence};
}

ScenarioCase expecting(const std::string& label, const std::string& expectation,
                       const std::string& sentence) {
  return section(label, "{vary: {operator: [mps, sph.gauss]}, expect: [" + expectation + "]}",
                 sentence);
}

class BadSection : public BadScenario {};
TEST_P(BadSection, IsRefused) { expect_refused(); }

/// What mote run and mote check refuse as well.
INSTANTIATE_TEST_SUITE_P(
    Compare, BadSection,
    testing::Values(
        section("compare_is_a_word", "@operator", "'compare' must be a section"),
        section("compare_with_unknown_key", "{@varry: {}}", "(did you mean 'vary'?)"),
        section("vary_is_a_list", "{vary: @[operator]}", "'vary' must be a section of key paths"),
        section("vary_one_value", "{vary: {operator: @mps}}", "'operator' must have a list"),
        section("vary_no_value", "{vary: {operator: @[]}}", "'operator' has no values"),
        section("vary_a_key_twice", "{vary: {operator: [mps], @operator: [sph.gauss]}}", "twice"),
        section("vary_a_value_twice", "{vary: {operator: [mps, @mps]}}", "has the value mps twice"),
        expecting("nothing_expected", "@{select: {operator: mps}}", "needs either 'fails_after'"),
        expecting("failure_and_error", "@{fails_after: 1, field: velocity, error: 1}",
                  "needs either 'fails_after'"),
        expecting("field_of_a_failure", "@{fails_after: 1, field: velocity}", "has no meaning"),
        expecting("error_of_no_field", "@{error: 1}", "needs a 'field'"),
        expecting("unknown_norm", "{field: velocity, norm: @l3, error: 1}", "unknown norm"),
        expecting("times_crossed", "@{fails_after: 2, fails_before: 1}", "must lie before"),
        expecting("orders_crossed", "@{field: velocity, least_order: 2, highest_order: 1}",
                  "must not lie above"),
        expecting("select_is_a_word", "{select: @mps, error: 1}", "'select' must be a section"),
        expecting("select_nothing", "{select: {operator: @}, fails_after: 1}",
                  "'operator' must have a value")),
    by_label);

/// What only mote compare can know.
class BadExpectation : public testing::TestWithParam<ScenarioCase> {};
TEST_P(BadExpectation, IsRefused) {
  const Marked marked = unmark(GetParam().text);
  const Workspace workspace(marked.text);
  workspace.expect_refusal(comparing({}),
                           {"scenario.yaml" + marked.place + ": ", GetParam().sentence});
}

INSTANTIATE_TEST_SUITE_P(
    Compare, BadExpectation,
    testing::Values(
        section("only_expected", "{expect: [{fails_after: 1}]}", "nothing is varied"),
        section("bad_member", "{vary: {operator: [mps, @sph.gaus]}}", "(did you mean 'gauss'?)"),
        section("unvaried_key", "{vary: {@threads: [1]}}", "'threads' cannot be varied"),
        expecting("selects_no_key", "@{select: {operatr: mps}, fails_after: 1}",
                  "'operatr' is not varied (did you mean 'operator'?)"),
        expecting("selects_no_value", "@{select: {operator: sph.lucy}, fails_after: 1}",
                  "no member has operator = sph.lucy"),
        expecting("unknown_field", "@{field: velocty, error: 1}", "(did you mean 'velocity'?)"),
        expecting("order_without_refinement", "@{field: velocity, least_order: 1}",
                  "an order needs two values")),
    by_label);

TEST(BadExpectation, OfAFieldThatStandingPointsHaveNoErrorOf) {
  const Workspace workspace(lines({{15, ""}}) +
                            "compare:\n  expect: [{field: position, error: 1}]\n");
  workspace.expect_refusal(comparing({"operator=mps,finite_difference"}),
                           {"scenario.yaml:17:12: ", "'position' has no error in"});
}

}  // namespace
}  // namespace mote::test
