// Sums over all pairs that cannot be made: nothing is written.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// Sources in the plane and in space, and targets away from them.
class SumWorkspace : public Workspace {
 public:
  SumWorkspace() {
    write(*this / "plane.csv", "x,y,strength\n0,0,1\n1,0,2\n0,1,-1\n");
    write(*this / "space.csv", "x,y,z,mass\n0,0,0,1\n1,0,0,2\n");
    write(*this / "targets.csv", "x,y\n4,0\n5,1\n");
  }
};

using Words = std::vector<std::string>;

Words summing(const std::string& points, const std::string& kernel, const Words& more = {}) {
  Words words{"sum", points, "--kernel", kernel, "--out", "out.csv"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Words cauchy(const Words& more) { return summing("plane.csv", "cauchy", more); }
Words gravity(const Words& more) { return summing("plane.csv", "gravity", more); }

/// The file `bad.csv` with these lines, and its sum.
CommandCase of_file(const std::string& label, const std::string& text, const std::string& place,
                    const std::string& sentence, const std::string& kernel = "cauchy") {
  return {label, summing("bad.csv", kernel), "mote: bad.csv" + place + ": ", sentence,
          [text](const Workspace& workspace) { write(workspace / "bad.csv", text); }};
}

/// The sum of good points at the targets of `bad.csv`.
CommandCase at_targets(const std::string& label, const std::string& text, const std::string& points,
                       const std::string& kernel, const std::string& beginning,
                       const std::string& sentence) {
  return {label, summing(points, kernel, {"--targets", "bad.csv"}), "mote: " + beginning, sentence,
          [text](const Workspace& workspace) { write(workspace / "bad.csv", text); }};
}

class BadSum : public testing::TestWithParam<CommandCase> {};
TEST_P(BadSum, IsRefused) {
  const SumWorkspace workspace;
  GetParam().prepare(workspace);
  workspace.expect_refusal(GetParam().arguments, {GetParam().beginning, GetParam().sentence});
}

const std::vector<CommandCase> bad_options{
    {"no_points", {"sum"}, "mote: ", "points is required"},
    {"no_kernel", {"sum", "plane.csv", "--out", "o.csv"}, "mote: ", "--kernel is required"},
    {"no_result", {"sum", "plane.csv", "--kernel", "cauchy"}, "mote: ", "--out is required"},
    {"kernel_unknown", summing("plane.csv", "cauchi"), "mote: --kernel: ", "cauchi"},
    {"method_unknown", cauchy({"--method", "tree"}), "mote: --method: ", "tree"},
    {"tolerance_too_small", cauchy({"--tolerance", "1e-15"}),
     "mote: --tolerance 1e-15: ", "from 1e-14 to 0.1"},
    {"tolerance_too_large", cauchy({"--tolerance", "0.2"}),
     "mote: --tolerance 0.2: ", "from 1e-14 to 0.1"},
    {"tolerance_negative", cauchy({"--tolerance", "-1e-8"}), "mote: --tolerance ", "1e-14 to 0.1"},
    {"tolerance_not_a_number", cauchy({"--tolerance", "nan"}), "mote: --tolerance ", "to 0.1"},
    {"tolerance_beyond_multipole", gravity({"--tolerance", "1e-14"}),
     "mote: the tolerance of multipole", "from 1e-13 to 1e-3"},
    {"tolerance_in_words", cauchy({"--tolerance", "small"}), "mote: ", "small"},
    {"series_of_gravity", gravity({"--method", "power_series", "--targets", "targets.csv"}),
     "mote: --method power_series: ", "gravity has no such sum; direct and multipole serve it"},
    {"series_at_the_sources", cauchy({"--method", "power_series"}),
     "mote: --method power_series: ", "this needs --targets"},
    {"core_unknown", gravity({"--core", "gaus", "--core-size", "1"}), "mote: --core: ", "gaus"},
    {"core_of_cauchy", cauchy({"--core", "gauss", "--core-size", "1"}), "mote: --core: ", "cauchy"},
    {"core_without_size", gravity({"--core", "gauss"}), "mote: --core gauss: ", "--core-size"},
    {"size_without_core", gravity({"--core-size", "1"}), "mote: --core-size: ", "--core"},
    {"size_of_points", gravity({"--core", "point", "--core-size", "1"}),
     "mote: --core-size: ", "points have no size"},
    {"size_negative", gravity({"--core", "gauss", "--core-size", "-1"}),
     "mote: --core-size -1: ", "positive"},
    {"size_0", gravity({"--core", "gauss", "--core-size", "0"}),
     "mote: --core-size 0: ", "positive"},
    {"size_infinite", gravity({"--core", "gauss", "--core-size", "inf"}),
     "mote: --core-size inf: ", "positive"},
    {"gradient_of_gravity", gravity({"--gradient"}), "mote: --gradient: ", "biot_savart"},
    {"threads_0", cauchy({"--threads", "0"}), "mote: --threads: ", "0"}};
INSTANTIATE_TEST_SUITE_P(Option, BadSum, testing::ValuesIn(bad_options), by_label);

Words into(const std::string& out, const Words& more = {}) {
  Words words{"sum", "plane.csv", "--kernel", "cauchy", "--out", out};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const std::vector<CommandCase> bad_results{
    {"ending", into("out.txt"), "mote: --out out.txt: ", "must end in .csv"},
    {"there_already", into("targets.csv"),
     "mote: targets.csv: ", "this file exists; --overwrite replaces it"},
    {"in_no_folder", into("nowhere/out.csv"), "mote: nowhere/out.csv: ", "no folder nowhere"},
    {"a_folder", into("a.csv", {"--overwrite"}), "mote: a.csv: ", "this is a folder",
     [](const Workspace& workspace) { fs::create_directory(workspace / "a.csv"); }}};
INSTANTIATE_TEST_SUITE_P(Result, BadSum, testing::ValuesIn(bad_results), by_label);

const std::vector<CommandCase> bad_sources{
    {"not_there", summing("nowhere.csv", "cauchy"), "mote: nowhere.csv: ", "there is no such file"},
    {"a_folder", summing(".", "cauchy"), "mote: .: ", "this is a folder, not a file"},
    of_file("without_points", "x,y,strength\n", ":1:1", "there are no points"),
    of_file("without_anything", "", ":1:1", "this file is empty"),
    of_file("without_x", "y,strength\n0,1\n", ":1:1",
            "there is no column x; there are: y, strength"),
    of_file("without_y", "x,strength\n0,1\n", "", "there is no column y; there are: x, strength"),
    of_file("in_words", "x,y,strength\n0,zero,1\n", ":2:3", "y of point 0 must be a number"),
    of_file("infinite", "x,y,strength\n0,0,1\n1,1,inf\n", ":3:5",
            "strength of point 1 is infinite"),
    of_file("cut_off", "x,y,strength\n0,0\n", ":2:1", "this row has 2 cells; the header has 3"),
    of_file("cauchy_without_strength", "x,y,mass\n0,0,1\n", "",
            "cauchy in 2D needs columns strength_re, strength_im or a column strength; there are: "
            "x, y, mass"),
    of_file("cauchy_half_complex", "x,y,strength_re\n0,0,1\n", "", "cauchy in 2D needs columns"),
    of_file("cauchy_in_space", "x,y,z,strength\n0,0,0,1\n", "", "cauchy is a sum in the plane"),
    of_file("gravity_without_mass", "x,y,m\n0,0,1\n", "",
            "gravity in 2D needs a column mass or a column strength; there are: x, y, m",
            "gravity"),
    of_file("vortices_without_circulation", "x,y,gamma\n0,0,1\n", "",
            "biot_savart in 2D needs a column circulation or a column strength", "biot_savart"),
    of_file("vortices_without_direction", "x,y,z,circulation\n0,0,0,1\n", "",
            "biot_savart in 3D needs columns circulation_x, circulation_y, circulation_z or",
            "biot_savart"),
    of_file("coincident", "x,y,strength\n0,0,1\n1,0,1\n0,0,2\n", "", "coincide")};
INSTANTIATE_TEST_SUITE_P(Source, BadSum, testing::ValuesIn(bad_sources), by_label);

const std::vector<CommandCase> bad_targets{
    {"not_there", cauchy({"--targets", "nowhere.csv"}),
     "mote: nowhere.csv: ", "there is no such file"},
    at_targets("without_points", "x,y\n", "plane.csv", "cauchy", "bad.csv:1:1: ", "no points"),
    at_targets("in_the_plane", "x,y\n4,0\n", "space.csv", "gravity", "bad.csv: ", "no column z"),
    at_targets("in_space", "x,y,z\n4,0,0\n", "plane.csv", "gravity",
               "bad.csv: ", "there is a column z, but the sources have none"),
    at_targets("on_a_source", "x,y\n4,0\n1,0\n", "plane.csv", "cauchy", "plane.csv: ", "source"),
    at_targets("on_a_mass", "x,y\n4,0\n1,0\n", "plane.csv", "gravity", "plane.csv: ", "source"),
    {"among_the_sources_of_a_series",
     cauchy({"--method", "power_series", "--targets", "plane.csv"}),
     "mote: plane.csv: ", "multipole and direct serve any points"}};
INSTANTIATE_TEST_SUITE_P(Target, BadSum, testing::ValuesIn(bad_targets), by_label);

/// The control: the same files, summed as they can be.
TEST(GoodSum, WritesTheResult) {
  const SumWorkspace workspace;
  const Outcome outcome =
      workspace.mote(cauchy({"--method", "power_series", "--targets", "targets.csv"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_TRUE(read(workspace / "out.csv").starts_with("x,y,value_re,value_im\n4,0,"));
}

}  // namespace
}  // namespace mote::test
