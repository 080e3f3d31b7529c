#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "study/csv_table.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using Names = std::vector<std::string>;

const std::string on_a_line =
    "name: line\ndimension: 1\nconstants: {L: 4}\ndomain: {lower: [0], upper: [L]}\nseed: 5\n"
    "field: \"sin(2*pi*x/L)\"\ndensity: \"1 + (x/L)^2\"\nlayouts: [regular, geometric, random]\n"
    "resolutions: [20, 40]\nextension: {type: formula, cells: 8}\n"
    "operators:\n"
    "  - {name: SPH0, family: sph, kernel: gauss, length: scatter}\n"
    "  - {family: mps, extension_cells: 2}\n"
    "norms: [l2, interior_max]\nmargin: 3\noutput: {picture: false}\n";

const std::string in_the_plane =
    "name: plane\ndimension: 2\ndomain: {lower: [0, -1], upper: [1, 0.5]}\n"
    "field: \"sin(x)*exp(y)\"\nvector_field: [\"x*y\", \"x^3\"]\n"
    "layouts: [lattice, {type: jittered, jitter: 0.15, seed: 9}]\nresolutions: [6, 12]\n"
    "operators: [sph.wendland_c2, {family: least_squares, degree: 2}]\noutput: {picture: false}\n";

const std::string in_space =
    "name: space\ndimension: 3\ndomain: {lower: [0, 0, 0], upper: [1, 1, 1]}\n"
    "field: \"x*y + z^2\"\nlayouts: [jittered]\nresolutions: [5]\noperators: [mps]\n"
    "output: {picture: false}\n";

/// A folder with a study, in which mote measures it.
class Place : public TemporaryFolder {
 public:
  explicit Place(const std::string& study) { write(*this / "study.yaml", study); }

  Outcome study(const Names& more = {}, const std::string& out = "out") const {
    Names arguments{"study", (*this / "study.yaml").string(), "--out", (*this / out).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mote(arguments);
  }
  std::string file(const std::string& name) const { return read(*this / name); }
  CsvTable table(const std::string& name) const { return CsvTable(file(name)); }
};

/// A study measured without a word of error.
struct Measured : Place {
  explicit Measured(const std::string& text, const Names& more = {}) : Place(text) {
    const Outcome outcome = study(more);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.errors, IsEmpty());
  }
};

/// The names of the columns of points.csv in front of the derivatives, and of these.
Names columns(const Names& front, const Names& derivatives) {
  Names names{"layout", "resolution", "operator", "index"};
  names.insert(names.end(), front.begin(), front.end());
  names.emplace_back("field");
  for (const auto& name : derivatives)
    for (const char* ending : {"_computed", "_exact"}) names.push_back(name + ending);
  return names;
}

TEST(Study, OfALineHasItsColumns) {
  const Measured measured(on_a_line);
  const CsvTable study = measured.table("out/study.csv"), points = measured.table("out/points.csv");
  EXPECT_EQ(study.names,
            (Names{"layout", "resolution", "operator", "quantity", "norm", "error", "order"}));
  EXPECT_EQ(study.rows.size(), 3u * 2 * 2 * 2 * 2);
  EXPECT_EQ(study.rows[0].at("operator"), "SPH0");
  EXPECT_EQ(study.where({{"resolution", "20"}, {"order", ""}}).size(), 3u * 2 * 2 * 2);
  EXPECT_TRUE(study.where({{"resolution", "40"}, {"order", ""}}).empty());
  EXPECT_EQ(points.names, columns({"x"}, {"gradient_x", "laplacian"}));
  EXPECT_EQ(points.rows.size(), 3u * 2 * (20 + 40));
  EXPECT_FALSE(fs::exists(measured / "out/check_up.csv"));
}

TEST(Study, OfThePlaneHasItsColumns) {
  const Measured measured(in_the_plane);
  const CsvTable points = measured.table("out/points.csv");
  EXPECT_EQ(points.names,
            columns({"x", "y"}, {"gradient_x", "gradient_y", "divergence", "curl", "hessian_xx",
                                 "hessian_xy", "hessian_yx", "hessian_yy", "laplacian"}));
  EXPECT_EQ(points.rows.size(), 2u * 2 * (6 * 9 + 12 * 18));
  EXPECT_EQ(measured.table("out/study.csv").rows.size(), 2u * 2 * 2 * 5 * 2);
}

TEST(Study, OfSpaceHasItsColumns) {
  const Measured measured(in_space);
  const CsvTable points = measured.table("out/points.csv");
  Names derivatives{"gradient_x", "gradient_y", "gradient_z", "divergence",
                    "curl_x",     "curl_y",     "curl_z"};
  for (const char* c : {"x", "y", "z"})
    for (const char* d : {"x", "y", "z"}) derivatives.push_back(std::string("hessian_") + c + d);
  derivatives.emplace_back("laplacian");
  EXPECT_EQ(points.names, columns({"x", "y", "z"}, derivatives));
  EXPECT_EQ(points.rows.size(), 125u);
}

TEST(Study, LeavesItsFilesAndNoOthers) {
  const auto files = [](const Place& place) {
    Names names;
    for (const auto& entry : fs::directory_iterator(place / "out"))
      names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
  };
  EXPECT_THAT(files(Measured(on_a_line)),
              ElementsAre("points.csv", "study.csv", "study.md", "study.yaml"));
  EXPECT_THAT(files(Measured(on_a_line, {"--set", "output.points=false"})),
              ElementsAre("study.csv", "study.md", "study.yaml"));
}

TEST(Study, SaysWhatItFound) {
  const Place place(on_a_line);
  const Outcome outcome = place.study();
  EXPECT_THAT(outcome.output, HasSubstr("report:  " + (place / "out/study.md").string()));
  EXPECT_THAT(outcome.output, HasSubstr("SPH0"));
  EXPECT_THAT(place.file("out/study.md"), HasSubstr("## Errors"));
  EXPECT_THAT(place.study({"--quiet"}, "second").output, IsEmpty());
}

const std::string marks =
    "check: [{operator: SPH0, layout: regular, norm: l2, error: 0.5, least_order: -9, "
    "highest_order: 9}]\n"
    "marks:\n"
    "  norm: l2\n"
    "  thresholds: [{quantity: gradient, good: 1e3, bad: 1e4}]\n"
    "  expected: [{operator: SPH0, marks: [good, good, bad]}]\n"
    "  exceptions: [{operator: SPH0, layout: random, because: \"A reason.\"}]\n"
    "  least_agreement: 2\n";

/// With every default written out, and derivatives as formulas.
TEST(Study, IsTheSameWhenItsOwnFileIsReadAgain) {
  const std::string by_hand =
      "derivatives: {gradient: [\"exp(y)*cos(x)\", \"x\"], hessian: [\"1\", \"x\", \"y\"]}\n";
  for (const std::string& text :
       {on_a_line + marks, in_the_plane, in_the_plane + by_hand, in_space}) {
    const Measured first(text), second(first.file("out/study.yaml"));
    for (const char* name : {"out/study.csv", "out/points.csv", "out/study.yaml", "out/study.md"})
      EXPECT_EQ(first.file(name), second.file(name)) << name;
  }
}

TEST(Study, TakesValuesFromTheCommandLine) {
  const Measured measured(on_a_line, {"--set", "resolutions=[10]", "--set", "layouts=[regular]",
                                      "--set", "operators=[{family: mps, name: only}]", "--set",
                                      "norms=[max]", "--set", "margin=0"});
  const CsvTable study = measured.table("out/study.csv");
  ASSERT_EQ(study.rows.size(), 2u);
  EXPECT_EQ(study.rows[0].at("resolution"), "10");
  EXPECT_EQ(study.rows[0].at("operator"), "only");
  EXPECT_EQ(study.rows[0].at("norm"), "max");
}

TEST(Study, ChangesWithItsSeedAlone) {
  const Measured first(on_a_line), other(on_a_line, {"--set", "seed=6"});
  const auto of = [](const Place& place, const std::string& layout) {
    return numbers(place.table("out/points.csv").where({{"layout", layout}}), "x");
  };
  EXPECT_EQ(of(first, "geometric"), of(other, "geometric"));
  EXPECT_NE(of(first, "random"), of(other, "random"));
}

/// Enough points that all loops run on several threads.
TEST(Study, IsTheSameAtAnyNumberOfThreads) {
  const Names of_line{"--set", "resolutions=[1200, 5000]", "--set", "layouts=[regular, random]"};
  const Names of_plane{"--set", "resolutions=[56]"};
  for (const auto& [text, set] :
       {std::pair(on_a_line, of_line), std::pair(in_the_plane, of_plane)}) {
    const auto with = [&](const std::string& threads) {
      Names more = set;
      more.insert(more.end(), {"--threads", threads});
      return more;
    };
    const Measured one(text, with("1"));
    ASSERT_GT(std::ranges::count(one.file("out/points.csv"), '\n'), 4000);
    for (const char* threads : {"2", "4"}) {
      const Measured several(text, with(threads));
      for (const char* name : {"out/study.csv", "out/points.csv"})
        EXPECT_TRUE(one.file(name) == several.file(name)) << name << ", " << threads << " threads";
    }
  }
}

TEST(Study, ExitsByItsChecks) {
  const Place place(on_a_line + marks);
  EXPECT_EQ(place.study().exit_code, 0);
  EXPECT_THAT(place.file("out/study.md"), HasSubstr("**Passed: every check holds.**"));
  const auto fails = [&](const std::string& assignment, const std::string& out) {
    const Outcome outcome = place.study({"--set", assignment}, out);
    EXPECT_EQ(outcome.exit_code, 1) << assignment;
    EXPECT_THAT(outcome.output, HasSubstr("FAILED"));
    EXPECT_THAT(place.file(out + "/study.md"), HasSubstr("**A check failed.**"));
  };
  fails("check=[{error: 1e-9}]", "error");
  fails("check=[{least_order: 9}]", "least_order");
  fails("check=[{highest_order: -9}]", "highest_order");
  fails("marks.least_agreement=3", "agreement");
}

TEST(Study, ReplacesAStudyAndNothingElse) {
  const Measured place(on_a_line);
  write(place / "out/notes.txt", "mine");
  write(place / "out/check_up.csv", "of the study before");
  const std::string before = place.file("out/study.csv");
  const Names set{"--set", "resolutions=[10]"};
  const Outcome refused = place.study(set);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("--overwrite replaces a former study"));
  EXPECT_EQ(place.file("out/study.csv"), before);
  EXPECT_EQ(place.study({"--set", "resolutions=[10]", "--overwrite"}).exit_code, 0);
  EXPECT_NE(place.file("out/study.csv"), before);
  EXPECT_EQ(place.file("out/notes.txt"), "mine");
  EXPECT_FALSE(fs::exists(place / "out/check_up.csv"));
}

TEST(Study, AndRunDoNotReplaceEachOther) {
  const Measured place(on_a_line);
  auto run = run_arguments("gravity/slab.yaml", place / "run", {"time.end=0.5"});
  EXPECT_LE(mote(run).exit_code, 1);
  const std::string summary = place.file("run/summary.json"), study = place.file("out/study.csv");
  const Outcome over_run = place.study({"--overwrite"}, "run");
  EXPECT_EQ(over_run.exit_code, 2);
  EXPECT_THAT(over_run.errors, HasSubstr("this folder is not the output of a study"));
  run = run_arguments("gravity/slab.yaml", place / "out", {"time.end=0.5"});
  run.emplace_back("--overwrite");
  const Outcome over_study = mote(run);
  EXPECT_EQ(over_study.exit_code, 2);
  EXPECT_THAT(over_study.errors, HasSubstr("this folder is not the output of a run"));
  EXPECT_EQ(place.file("run/summary.json"), summary);
  EXPECT_EQ(place.file("out/study.csv"), study);
}

TEST(Study, IsNotAScenario) {
  const Place place(on_a_line);
  for (const char* command : {"run", "check"}) {
    const Outcome outcome = mote({command, (place / "study.yaml").string()});
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_THAT(outcome.errors,
                HasSubstr("this is a study and not a scenario: mote study runs it"));
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1);
  }
  const Outcome outcome =
      mote({"study", MOTE_SCENARIOS "/gravity/slab.yaml", "--out", (place / "out").string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("this is a scenario and not a study: mote run runs it"));
  EXPECT_FALSE(fs::exists(place / "out"));
}

TEST(Study, HasASchema) {
  const Outcome outcome = mote({"schema", "study"});
  EXPECT_EQ(outcome.exit_code, 0);
  const json schema = json::parse(outcome.output);
  EXPECT_EQ(schema["title"], "mote study");
  const json operators = schema["anyOf"][0]["properties"];
  for (const char* key : {"field", "layouts", "operators", "resolutions", "check", "marks"})
    EXPECT_TRUE(operators.contains(key)) << key;
  EXPECT_EQ(operators["layouts"]["type"], "array");
  for (const char* key : {"table", "decades", "schemes", "check"})
    EXPECT_NE(schema["anyOf"][1].dump().find('"' + std::string(key) + '"'), std::string::npos)
        << key;
  const json interpolation = schema["anyOf"][2]["properties"];
  for (const char* key : {"name", "interpolation", "output", "check"})
    EXPECT_TRUE(interpolation.contains(key)) << key;
  EXPECT_NE(outcome.output, mote({"schema", "scenario"}).output);
}

TEST(Study, TabulatesDifferences) {
  const TemporaryFolder folder;
  const auto file =
      write(folder / "table.yaml",
            "name: t\ntable: fourth_difference\ncheck: [{scheme: usual, error: 1.0e-10}]\n");
  const std::string out = (folder / "out").string();
  EXPECT_EQ(mote({"study", file.string(), "--out", out}).exit_code, 1);
  EXPECT_EQ(
      mote({"study", file.string(), "--out", out, "--overwrite", "--set", "check=[]"}).exit_code,
      0);
  EXPECT_EQ(mote({"run", file.string()}).exit_code, 2);
}

TEST(Study, TabulatesInterpolation) {
  const Place place(
      "name: t\ninterpolation: {eccentricities: [0.1, 0.5], sub_intervals: [5, 8]}\n"
      "output: {picture: false}\n"
      "check: [{path: cubic_hermite, eccentricity: 0.5, sub_intervals: 8, error: 1.0e-9}]\n");
  const Outcome outcome = place.study();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("8 sub-intervals"));
  EXPECT_THAT(outcome.output, HasSubstr("FAILED"));
  EXPECT_EQ(place.table("out/study.csv").rows.size(), 2u * 2 * 4);
  EXPECT_THAT(place.file("out/study.md"), HasSubstr("**A check failed.**"));
  for (const char* threads : {"1", "2", "4"}) {
    EXPECT_EQ(place.study({"--set", "check=[]", "--threads", threads}, threads).exit_code, 0);
    EXPECT_EQ(place.file(std::string(threads) + "/study.csv"), place.file("out/study.csv"));
  }
  EXPECT_EQ(mote({"run", (place / "study.yaml").string()}).exit_code, 2);
}

std::string of_points(const std::string& path, int dimension = 2) {
  return "name: own\ndimension: " + std::to_string(dimension) +
         "\nfield: \"exp(x)\"\nlayouts: [{type: file, path: \"" + path +
         "\", name: mine}]\noperators: [sph.wendland_c2]\noutput: {picture: false}\n";
}

/// A square of side n, rows of points.
std::string square(int n) {
  std::string csv = "x,y\n";
  for (int k = 0; k < n * n; ++k) csv += std::to_string(k % n) + "," + std::to_string(k / n) + "\n";
  return csv;
}

/// In the middle the cells whose midpoints lie within R = 4 fill a ball of (1 -+ sqrt(1/2)/R) R.
TEST(StudyOfPoints, ChecksThemUp) {
  const Place place(of_points("p.csv"));
  write(place / "p.csv", square(25));
  ASSERT_EQ(place.study().exit_code, 0);
  const CsvTable check_up = place.table("out/check_up.csv");
  EXPECT_EQ(check_up.names,
            (Names{"layout", "operator", "index", "x", "y", "neighbours", "covered", "condition"}));
  ASSERT_EQ(check_up.rows.size(), 625u);
  EXPECT_LT(std::stod(check_up.rows[0].at("neighbours")),
            std::stod(check_up.rows[312].at("neighbours")));
  EXPECT_NEAR(std::stod(check_up.rows[312].at("covered")), 1, 2 * std::sqrt(0.5) / 4);
  EXPECT_LT(std::stod(check_up.rows[0].at("covered")), 0.5);
  EXPECT_EQ(place.table("out/study.csv").rows[0].at("resolution"), "625");
  EXPECT_THAT(place.file("out/study.md"), HasSubstr("## Check-up of the points"));
  EXPECT_THAT(place.file("out/study.md"), HasSubstr("how closely the points lie"));
}

TEST(StudyOfPoints, AreCheckedUpTheSameAtAnyNumberOfThreads) {
  std::string one;
  for (const char* threads : {"1", "2", "4"}) {
    const Place place(of_points("p.csv"));
    write(place / "p.csv", square(70));
    ASSERT_EQ(place.study({"--threads", threads}).exit_code, 0);
    const std::string files = place.file("out/check_up.csv") + place.file("out/points.csv");
    if (one.empty()) one = files;
    EXPECT_TRUE(files == one) << threads << " threads";
  }
}

TEST(StudyOfPoints, ReadsASnapshotOfOurs) {
  const Place place(of_points("run/snapshots/000001.hdf", 1));
  EXPECT_LE(mote(run_arguments("gravity/slab.yaml", place / "run", {"time.end=0.5"})).exit_code, 1);
  ASSERT_TRUE(fs::exists(place / "run/snapshots/000001.hdf"));
  const Outcome outcome = place.study();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const CsvTable check_up = place.table("out/check_up.csv");
  EXPECT_EQ(check_up.names,
            (Names{"layout", "operator", "index", "x", "neighbours", "covered", "condition"}));
  EXPECT_EQ(std::to_string(check_up.rows.size()),
            place.table("out/study.csv").rows[0].at("resolution"));
}

/// The file's own field takes the place of the formula, whose derivatives stay the exact ones.
TEST(StudyOfPoints, TakesTheFieldOfTheFile) {
  const Place place(of_points("p.csv", 1));
  write(place / "p.csv", "x,field\n3,30\n1,10\n2,20\n4,40\n");
  ASSERT_EQ(place.study().exit_code, 0);
  const CsvTable points = place.table("out/points.csv");
  EXPECT_THAT(numbers(points.rows, "x"), ElementsAre(3, 1, 2, 4));
  EXPECT_THAT(numbers(points.rows, "field"), ElementsAre(30, 10, 20, 40));
  EXPECT_NEAR(numbers(points.rows, "gradient_x_exact")[0], std::exp(3.0), 1e-12);
}

}  // namespace
}  // namespace mote::test
