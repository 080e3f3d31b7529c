// The command line: commands, options, --set, and scenario files that are not there.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

const std::string too_long(300, 'a');

class BadCommand : public testing::TestWithParam<CommandCase> {};
TEST_P(BadCommand, IsRefused) {
  const Workspace workspace;
  GetParam().prepare(workspace);
  workspace.expect_refusal(GetParam().arguments, {GetParam().beginning, GetParam().sentence});
}

const std::vector<CommandCase> bad_commands{
    {"none", {}, "mote: ", "subcommand is required"},
    {"unknown", {"frobnicate"}, "mote: ", "frobnicate"},
    {"misspelt", {"chek", "scenario.yaml"}, "mote: ", "(did you mean 'check'?)"},
    {"option_without_command", {"--colour"}, "mote: ", "--colour"},
    {"unknown_option", running({"--colour"}), "mote: ", "--colour"},
    {"option_of_another_command", {"check", "scenario.yaml", "--out", "out"}, "mote: ", "--out"},
    {"overwrite_of_resume", {"resume", ".", "--overwrite"}, "mote: ", "--overwrite"},
    {"one_argument_too_many", running({"more"}), "mote: ", "more"},
    {"file_missing", {"run"}, "mote: ", "file is required"},
    {"file_of_check_missing", {"check"}, "mote: ", "file is required"},
    {"folder_missing", {"resume"}, "mote: ", "folder is required"},
    {"threads_0", running({"--out", "out", "--threads", "0"}), "mote: --threads: ", "0"},
    {"threads_negative", running({"--out", "out", "--threads", "-1"}), "mote: --threads: ", "-1"},
    {"threads_many", running({"--out", "out", "--threads", "5000"}), "mote: --threads: ", "5000"},
    {"threads_in_words", running({"--out", "out", "--threads", "two"}), "mote: --threads: ", "two"},
    {"threads_without_number", running({"--threads"}), "mote: --threads: ", "missing"},
    {"out_without_folder", running({"--out"}), "mote: --out: ", "missing"},
    {"out_twice", running({"--out", "a", "--out", "b"}), "mote: --out: ", "received 2"},
    {"set_without_assignment", running({"--set"}), "mote: --set: ", "missing"},
    {"list_of_nothing", {"list"}, "mote: ", "required"},
    {"list_of_unknown", {"list", "kernles"}, "mote: ", "kernles"}};
INSTANTIATE_TEST_SUITE_P(Table, BadCommand, testing::ValuesIn(bad_commands), by_label);

CommandCase assigning(const std::string& label, const std::string& assignment,
                      const std::string& sentence) {
  return {label, setting(assignment), "--set " + assignment + ": ", sentence};
}

const std::vector<CommandCase> bad_assignments{
    assigning("unknown_path", "partcles.count=3", "(did you mean 'particles'?)"),
    assigning("unknown_nested_path", "particles.number=3", "unknown key 'number' in section"),
    assigning("unknown_check", "check.pressure=1", "unknown key 'pressure' in section 'check'"),
    assigning("without_equals_sign", "particles.count", "must have the form key.path=value"),
    assigning("without_path", "=3", "must have the form key.path=value"),
    assigning("empty_key_first", ".count=3", "key"),
    assigning("empty_key_within", "particles..count=3", "key"),
    assigning("without_value", "particles.count=", "and nothing is given"),
    assigning("section_without_value", "particles=", "'particles' must be a section"),
    assigning("number_for_a_section", "particles=3", "'particles' must be a section"),
    assigning("into_a_list", "domain.upper.0=3", "a list is set as a whole"),
    assigning("into_a_word", "name.first=a", "name"),
    assigning("into_a_number", "dimension.x=1", "dimension"),
    assigning("not_yaml", "domain.upper=[3", "this is not YAML"),
    assigning("wrong_type", "name=[base]", "'name' must be a text"),
    assigning("unknown_word", "operator=sph.gaus", "(did you mean 'gauss'?)"),
    assigning("out_of_range", "particles.count=1", "'count' must be from 2"),
    assigning("bad_expression", "initial.density=1 + y0", "unknown name 'y0'"),
    assigning("density_negative", "initial.density=x - 2", "must be positive everywhere"),
    assigning("step_beyond_the_limit", "time.step=8", "beyond the stability limit"),
    assigning("end_beyond_the_exact_solution", "time.end=30", "before the run does at t = 30"),
    {"of_two_lines", setting("name=[a,\n b]"), "--set name=[a,", "'name' must be a text"},
    {"kernel_that_mps_does_not_take", setting("operator.family=mps"),
     "scenario.yaml:10:25: ", "unknown key 'kernel'"}};
INSTANTIATE_TEST_SUITE_P(Set, BadCommand, testing::ValuesIn(bad_assignments), by_label);

const std::vector<CommandCase> bad_files{
    {"not_there",
     {"run", "nowhere.yaml", "--out", "out"},
     "nowhere.yaml: ",
     "cannot read this file"},
    {"not_there_for_check", {"check", "nowhere.yaml"}, "nowhere.yaml: ", "cannot read this file"},
    {"in_no_folder",
     {"run", "a/b/c.yaml", "--out", "out"},
     "a/b/c.yaml: ",
     "cannot read this file"},
    {"a_folder", {"run", ".", "--out", "out"}, ".: ", "this is a folder, not a file"},
    {"below_a_file",
     {"run", "scenario.yaml/a", "--out", "out"},
     "scenario.yaml/a: ",
     "cannot read"},
    {"no_name", {"run", "", "--out", "out"}, "mote: ", "file"},
    {"name_too_long", {"run", too_long, "--out", "out"}, too_long + ": ", "cannot read this file"},
    {"name_too_long_for_check", {"check", too_long}, too_long + ": ", "cannot read this file"}};
INSTANTIATE_TEST_SUITE_P(File, BadCommand, testing::ValuesIn(bad_files), by_label);

}  // namespace
}  // namespace mote::test
