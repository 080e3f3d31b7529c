// Study files that are wrong, and studies that cannot be measured.

#include <sstream>

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// By lines, counted from 1.
const std::string good_study = R"(name: base
dimension: 2
constants: {L: 1}
domain: {lower: [0, 0], upper: [L, 1]}
field: "sin(x)*y"
density: "1 + x"
layouts: [lattice, {type: jittered, jitter: 0.2}]
resolutions: [4, 8]
extension: {type: formula, cells: 4}
operators:
  - {name: A, family: sph, kernel: wendland_c2, smoothing_length: 1.5}
  - {name: B, family: mps}
quantities: [gradient, laplacian]
norms: [l2, max]
output: {picture: false}
check:
  - {operator: A, layout: lattice, quantity: gradient, error: 1}
marks:
  norm: max
  thresholds: [{quantity: gradient, good: 0.1, bad: 0.2}]
  expected:
    - {operator: A, quantity: gradient, marks: [good, good]}
)";

/// The good study with some lines, counted from 1, replaced.
std::string edited(const std::map<int, std::string>& edits) {
  std::istringstream lines(good_study);
  std::string text, line;
  for (int number = 1; std::getline(lines, line); ++number)
    text += (edits.contains(number) ? edits.at(number) : line) + "\n";
  return text;
}

std::string row(int number, const std::string& text) { return edited({{number, text}}); }

const std::vector<std::string> measuring{"study", "scenario.yaml", "--out", "out"};

/// Bad study files: refused before anything is written.
class BadStudy : public testing::TestWithParam<ScenarioCase> {};
TEST_P(BadStudy, IsRefused) {
  const Marked marked = unmark(GetParam().text);
  Workspace(marked.text)
      .expect_refusal(measuring, {"scenario.yaml" + marked.place + ": ", GetParam().sentence});
}

const std::vector<ScenarioCase> unknown_keys{
    {"name", row(1, "@nme: base"), "unknown key 'nme' (did you mean 'name'?) in the study"},
    {"of_scenarios", row(15, "@output_every: 1"), "unknown key 'output_every'"},
    {"lower", row(4, "domain: {@lowr: [0, 0], upper: [L, 1]}"), "(did you mean 'lower'?)"},
    {"layout_type", row(7, "layouts: [lattice, {@typ: jittered}]"), "(did you mean 'type'?)"},
    {"jitter", row(7, "layouts: [lattice, {type: jittered, @jiter: 0.2}]"),
     "(did you mean 'jitter'?)"},
    {"jitter_of_a_lattice", row(7, "layouts: [{type: lattice, @jitter: 0.2}]"),
     "unknown key 'jitter'"},
    {"path_of_no_file", row(7, "layouts: [{type: jittered, @path: p.csv}]"), "unknown key 'path'"},
    {"cells", row(9, "extension: {type: formula, @cels: 4}"), "(did you mean 'cells'?)"},
    {"cells_of_none", row(9, "extension: {type: none, @cells: 4}"), "unknown key 'cells'"},
    {"family", row(12, "  - {name: B, @famly: mps}"), "(did you mean 'family'?)"},
    {"kernel", row(11, "  - {name: A, family: sph, @kernl: gauss}"), "(did you mean 'kernel'?)"},
    {"smoothing_length", row(12, "  - {family: mps, @smoothing_lenth: 1}"),
     "(did you mean 'smoothing_length'?) in section 'operators'"},
    {"picture", row(15, "output: {@pictre: false}"), "(did you mean 'picture'?)"},
    {"checked_operator", row(17, "  - {@operater: A, error: 1}"), "(did you mean 'operator'?)"},
    {"error", row(17, "  - {operator: A, @eror: 1}"), "(did you mean 'error'?)"},
    {"orders_swapped", row(17, "  - @{least_order: 2, highest_order: 1}"),
     "'least_order' must not lie above 'highest_order'"},
    {"agreement_of_more_than_all", row(19, "  least_agreement: @3"), "there are only 2 marks"},
    {"thresholds_twice", row(20, "  thresholds: [{good: 1, bad: 2}, @{good: 1, bad: 2}]"),
     "the gradient has its thresholds already"},
    {"norm_of_marks", row(19, "  @nrm: max"), "(did you mean 'norm'?) in section 'marks'"},
    {"good", row(20, "  thresholds: [{quantity: gradient, @god: 0.1, bad: 0.2}]"),
     "(did you mean 'good'?) in section 'thresholds'"},
    {"quantity", row(22, "    - {operator: A, @quantitie: gradient, marks: [good, good]}"),
     "(did you mean 'quantity'?) in section 'expected'"},
    {"because", row(19, "  exceptions: [{operator: A, layout: lattice, @becaus: x}]"),
     "(did you mean 'because'?) in section 'exceptions'"},
    {"gradient", row(6, "derivatives: {@gradint: [\"1\", \"2\"]}"), "(did you mean 'gradient'?)"}};
INSTANTIATE_TEST_SUITE_P(UnknownKey, BadStudy, testing::ValuesIn(unknown_keys), by_label);

const std::vector<ScenarioCase> unknown_words{
    {"layout", row(7, "layouts: [@latice]"), "(did you mean 'lattice'?); there are: regular"},
    {"layout_in_full", row(7, "layouts: [lattice, {type: @jitterd}]"), "mean 'jittered'?)"},
    {"layout_of_a_line", row(7, "layouts: [@regular]"), "'regular' is a mesh of a line; in 2 "},
    {"family", row(12, "  - {family: @msp}"), "(did you mean 'mps'?)"},
    {"kernel_in_short", row(12, "  - @sph.gaus"), "(did you mean 'gauss'?)"},
    {"family_in_short", row(12, "  - @spf.gauss"), "(did you mean 'sph'?)"},
    {"quantity", row(13, "quantities: [gradient, @laplacan]"), "(did you mean 'laplacian'?)"},
    {"norm", row(14, "norms: [l2, @maxx]"), "(did you mean 'max'?)"},
    {"mark", row(22, "    - {operator: A, marks: [good, @god]}"), "(did you mean 'good'?)"},
    {"extension", row(9, "extension: {type: @mirro}"), "(did you mean 'mirror'?)"},
    {"units", row(6, "units: @cgs"), "there are: none, SI"},
    {"checked_quantity", row(17, "  - {quantity: @gradiant, error: 1}"), "mean 'gradient'?)"}};
INSTANTIATE_TEST_SUITE_P(UnknownWord, BadStudy, testing::ValuesIn(unknown_words), by_label);

const std::vector<ScenarioCase> missing{
    {"name", row(1, ""), "the study lacks the key 'name'"},
    {"dimension", row(2, ""), "the study lacks the key 'dimension'"},
    {"domain", row(4, ""), "the study lacks the key 'domain'"},
    {"lower", row(4, "domain: @{upper: [1, 1]}"), "'lower' needs 2 numbers"},
    {"field", row(5, ""), "the study lacks the key 'field'"},
    {"layouts", row(7, ""), "the study lacks the key 'layouts'"},
    {"layout_type", row(7, "layouts: [@{name: x}]"), "section 'layouts' lacks the key 'type'"},
    {"path", row(7, "layouts: [@{type: file}]"), "section 'layouts' lacks the key 'path'"},
    {"resolutions", row(8, ""), "the study lacks the key 'resolutions'"},
    {"operators", edited({{10, ""}, {11, ""}, {12, ""}}), "the study lacks the key 'operators'"},
    {"kernel", row(12, "  - @{family: sph}"), "section 'operators' lacks the key 'kernel'"},
    {"good", row(20, "  thresholds: [@{quantity: gradient, bad: 0.2}]"), "lacks the key 'good'"},
    {"marks", row(22, "    - @{operator: A, quantity: gradient}"), "lacks the key 'marks'"}};
INSTANTIATE_TEST_SUITE_P(MissingKey, BadStudy, testing::ValuesIn(missing), by_label);

const std::vector<ScenarioCase> wrong_types{
    {"dimension", row(2, "dimension: @two"), "'dimension' must be a number"},
    {"word_for_layouts", row(7, "layouts: @lattice"), "'layouts' must be a list"},
    {"section_for_layouts", row(7, "layouts: @{type: lattice}"), "'layouts' must be a list"},
    {"nothing_for_layouts", row(7, "@layouts:"), "'layouts' must be a list, and nothing is given"},
    {"nothing_in_layouts", row(7, "layouts: [@~]"), "'layouts' must be a section"},
    {"list_in_layouts", row(7, "layouts: [@[lattice]]"), "'layouts' must be a section"},
    {"no_layouts", row(7, "layouts: @[]"), "'layouts' must not be empty"},
    {"no_operators", edited({{10, "operators: @[]"}, {11, ""}, {12, ""}}), "must not be empty"},
    {"word_for_operators", edited({{10, "operators: @mps"}, {11, ""}, {12, ""}}), "must be a list"},
    {"no_quantities", row(13, "quantities: @[]"), "'quantities' must not be empty"},
    {"word_for_quantities", row(13, "quantities: @gradient"), "'quantities' must be a list"},
    {"list_in_quantities", row(13, "quantities: [@[gradient]]"), "must be a list of words"},
    {"no_norms", row(14, "norms: @[]"), "'norms' must not be empty"},
    {"no_marks", row(22, "    - {operator: A, marks: @[]}"), "'marks' must not be empty"},
    {"number_for_resolutions", row(8, "resolutions: @8"),
     "'resolutions' must be a list of numbers"},
    {"word_in_resolutions", row(8, "resolutions: [4, @eight]"), "'resolutions' must be a number"},
    {"expression_for_vector_field", row(6, "vector_field: @\"x\""),
     "must be a list of expressions"},
    {"list_for_field", row(5, "field: @[x, y]"), "'field' must be a number or an expression"},
    {"word_for_points", row(15, "output: {points: @all}"), "'points' must be true or false"},
    {"list_for_check", row(17, "  - @[A, 1]"), "'check' must be a section"},
    {"key_given_twice", row(6, "@field: \"x\""), "the key 'field' is given twice"}};
INSTANTIATE_TEST_SUITE_P(WrongType, BadStudy, testing::ValuesIn(wrong_types), by_label);

const std::vector<ScenarioCase> wrong_numbers{
    {"dimension_four", row(2, "dimension: @4"), "'dimension' must be from 1 to 3, and is 4"},
    {"dimension_half", row(2, "dimension: @1.5"), "'dimension' must be a whole number"},
    {"corners", row(4, "domain: {lower: @[0], upper: [1]}"), "'lower' needs 2 numbers"},
    {"corners_swapped", row(4, "domain: {lower: [0, 1], upper: @[1, 0]}"), "must lie above"},
    {"corners_equal", row(4, "domain: {lower: [0, 1], upper: @[1, 1]}"), "must lie above"},
    {"no_resolutions", row(8, "resolutions: @[]"), "resolutions"},
    {"resolutions_falling", row(8, "resolutions: @[8, 4]"), "the resolutions must rise"},
    {"resolutions_equal", row(8, "resolutions: @[8, 8]"), "the resolutions must rise"},
    {"resolution_half", row(8, "resolutions: @[4.5]"), "a whole number from 2 to 1e8, and not 4.5"},
    {"resolution_one", row(8, "resolutions: @[1]"), "a whole number from 2 to 1e8, and not 1"},
    {"resolution_negative", row(8, "resolutions: @[-4]"), "and not -4"},
    {"resolution_nan", row(8, "resolutions: [@.nan]"), "finite decimal number"},
    {"jitter", row(7, "layouts: [{type: jittered, jitter: @0.51}]"), "must be from 0 to 0.5"},
    {"jitter_negative", row(7, "layouts: [{type: jittered, jitter: @-0.1}]"), "from 0 to 0.5"},
    {"seed", row(6, "seed: @-3"), "'seed' must be at least 0, and is -3"},
    {"seed_of_a_layout", row(7, "layouts: [{type: jittered, seed: @-1}]"), "must be at least 0"},
    {"seed_half", row(7, "layouts: [{type: jittered, seed: @0.5}]"), "must be a whole number"},
    {"cells", row(9, "extension: {type: formula, cells: @-1}"), "from 0 to 1000000, and is -1"},
    {"extension_cells", row(12, "  - {family: mps, extension_cells: @-1}"), "and is -1"},
    {"margin", edited({{6, "margin: @2"}, {14, "norms: [max, l2, interior_l2]"}}),
     "a margin of 2 cells leaves none of 4"},
    {"margin_of_the_short_side",
     edited({{4, "domain: {lower: [0, 0], upper: [1, 0.5]}"},
             {6, "margin: @1"},
             {14, "norms: [max, l2, interior_l2]"}}),
     "a margin of 1 cells leaves none of 2 along y"},
    {"margin_of_no_norm", row(6, "margin: @1"), "a margin has a meaning for interior norms alone"},
    {"margin_negative", row(6, "margin: @-1"), "'margin' must be at least 0, and is -1"},
    {"error_zero", row(17, "  - {error: @0}"), "'error' must be greater than 0, and is 0"},
    {"threshold_zero", row(20, "  thresholds: [{good: @0, bad: 0.2}]"), "greater than 0"},
    {"agreement", row(19, "  least_agreement: @-3"), "must be at least 0, and is -3"}};
INSTANTIATE_TEST_SUITE_P(WrongNumber, BadStudy, testing::ValuesIn(wrong_numbers), by_label);

/// A study of a line.
std::string of_a_line(const std::string& layouts, const std::string& more) {
  return "name: base\ndimension: 1\ndomain: {lower: [0], upper: [1]}\nfield: \"x\"\nlayouts: " +
         layouts + "\nresolutions: [4]\noperators: [mps]\n" + more + "\n";
}

const std::vector<ScenarioCase> wrong_fields{
    {"syntax", row(5, "field: @\"sin(x\""), "a parenthesis is not closed"},
    {"unknown_name", row(5, "field: @\"sin(q)\""), "unknown name 'q'"},
    {"clamp", row(5, "field: @\"clamp(x, 0, 1)\""),
     "'clamp' has no symbolic derivative; give 'gradient' in the section 'derivatives'"},
    {"condition", row(5, "field: @\"x < 0.5 ? 1 : x\""),
     "a condition has no symbolic derivative; give 'gradient' in the section 'derivatives'"},
    {"clamp_in_a_given_gradient", row(6, "derivatives: {gradient: @[\"clamp(x,0,1)\", \"1\"]}"),
     "give 'hessian' in the section 'derivatives'"},
    {"clamp_in_a_vector_field",
     edited(
         {{6, "vector_field: @[\"clamp(x, 0, 1)\", \"y\"]"}, {13, "quantities: [gradient, curl]"}}),
     "give 'jacobian' in the section 'derivatives'"},
    {"time", row(5, "field: @\"x*t\""), "'field' depends on t, a study has no time"},
    {"third_coordinate", row(6, "density: @\"1 + z^2\""), "'density' depends on z, which 2"},
    {"one_component", row(6, "vector_field: @[\"x\"]"),
     "'vector_field' needs 2 expressions, one a dimension, and has 1"},
    {"one_derivative", row(6, "derivatives: {gradient: @[\"1\"]}"),
     "'gradient' needs 2 expressions, and has 1"},
    {"three_derivatives", row(6, "derivatives: {gradient: @[\"1\", \"1\", \"1\"]}"),
     "'gradient' needs 2 expressions, and has 3"},
    {"two_second_derivatives", row(6, "derivatives: {hessian: @[\"1\", \"2\"]}"),
     "'hessian' needs 3 expressions, and has 2"},
    {"one_of_a_jacobian", row(6, "derivatives: {jacobian: @[\"1\"]}"),
     "'jacobian' needs 4 expressions, and has 1"},
    {"curl_on_a_line", of_a_line("[regular]", "quantities: @[gradient, curl]"),
     "a line has no curl"}};
INSTANTIATE_TEST_SUITE_P(WrongField, BadStudy, testing::ValuesIn(wrong_fields), by_label);

const std::vector<ScenarioCase> wrong_names{
    {"of_a_folder", row(1, "name: @\"a/b\""), "'a/b' cannot name a folder"},
    {"two_layouts", row(7, "layouts: [lattice, @lattice]"), "two layouts are called 'lattice'"},
    {"two_layouts_by_default", row(7, "layouts: [jittered, @{type: lattice, name: jittered}]"),
     "two layouts are called 'jittered'; give one of them another 'name'"},
    {"two_operators", edited({{11, "  - mps"}, {12, "  - @{name: mps, family: mps}"}}),
     "two operators are called 'mps'; give one of them another 'name'"},
    {"with_a_comma", edited({{11, "  - @{name: \"A,B\", family: mps}"}}),
     "the name 'A,B' cannot stand in a table"},
    {"quantity_twice", row(13, "quantities: @[gradient, gradient]"), "'gradient' is named twice"},
    {"norm_twice", row(14, "norms: @[l2, max, l2]"), "'l2' is named twice"}};
INSTANTIATE_TEST_SUITE_P(WrongName, BadStudy, testing::ValuesIn(wrong_names), by_label);

const std::vector<ScenarioCase> wrong_checks{
    {"operator", row(17, "  - @{operator: Z, error: 1}"), "there is no operator 'Z'"},
    {"layout", row(17, "  - @{layout: latice, error: 1}"),
     "there is no layout 'latice' (did you mean 'lattice'?)"},
    {"quantity", row(17, "  - @{quantity: curl, error: 1}"), "the study does not measure the curl"},
    {"norm", row(17, "  - @{norm: l1, error: 1}"), "the study does not measure the norm l1"},
    {"nothing", row(17, "  - @{operator: A}"), "a check needs 'error', 'least_order' or"},
    {"order_of_one_resolution", edited({{8, "resolutions: [8]"}, {17, "  - @{least_order: 1}"}}),
     "an order needs two resolutions"},
    {"orders_swapped", row(17, "  - @{least_order: 2, highest_order: 1}"),
     "'least_order' must not lie above 'highest_order'"},
    {"agreement_of_more_than_all", row(19, "  least_agreement: @3"), "there are only 2 marks"},
    {"thresholds_twice", row(20, "  thresholds: [{good: 1, bad: 2}, @{good: 1, bad: 2}]"),
     "the gradient has its thresholds already"},
    {"norm_of_marks", row(19, "  norm: @l1"), "the study does not measure the norm l1"},
    {"thresholds_swapped", row(20, "  thresholds: [@{quantity: gradient, good: 0.3, bad: 0.2}]"),
     "the threshold 'bad' must not lie below 'good'"},
    {"no_thresholds", edited({{20, ""}, {22, "    - @{operator: A, marks: [good, good]}"}}),
     "there are no thresholds for the gradient"},
    {"thresholds_of_others",
     edited({{20, "  thresholds: [{quantity: laplacian, good: 0.1, bad: 0.2}]"},
             {22, "    - @{operator: A, marks: [good, good]}"}}),
     "there are no thresholds for the gradient"},
    {"too_few_marks", row(22, "    - @{operator: A, marks: [good]}"),
     "'marks' needs one word for each of the 2 layouts, and has 1"},
    {"marked_operator", row(22, "    - @{operator: Z, marks: [good, good]}"),
     "there is no operator 'Z'"},
    {"marked_quantity", row(22, "    - @{operator: A, quantity: hessian, marks: [good, good]}"),
     "the study does not measure the hessian"},
    {"exception", row(19, "  exceptions: [@{operator: A, layout: latice, because: x}]"),
     "there is no layout 'latice'"},
    {"interior_of_a_file",
     edited({{7, "layouts: [lattice, {type: file, path: p.csv}]"},
             {14, "norms: @[max, interior_l2]"}}),
     "the ends of a file of points are not known"}};
INSTANTIATE_TEST_SUITE_P(WrongCheck, BadStudy, testing::ValuesIn(wrong_checks), by_label);

/// Studies that are told only when they are measured: no folder is left behind then.
class BrokenStudy : public testing::TestWithParam<ScenarioCase> {};

TEST_P(BrokenStudy, IsTold) {
  const Marked marked = unmark(GetParam().text);
  const Workspace workspace(marked.text);
  const Refusal refusal{"scenario.yaml" + marked.place + ": ", GetParam().sentence};
  for (const auto& fault : faults(workspace.mote(measuring), refusal)) ADD_FAILURE() << fault;
  EXPECT_FALSE(fs::exists(workspace / "out"));
}

const std::vector<ScenarioCase> broken{
    {"field", row(5, "field: @\"1/(x - 0.125)\""), "'field' has no finite value at (0.125, 0.125"},
    {"density", row(6, "density: @\"log(x - 0.5)\""), "'density' has no finite value at (0.125"},
    {"density_zero",
     edited(
         {{6, "density: @\"x - 0.125\""}, {11, "  - {name: A, family: sph, kernel: wendland_c2}"}}),
     "the density must be positive, and is 0 at (0.125, 0.125)"},
    {"too_many_points", row(8, "resolutions: @[100000]"), "makes more than 1e8 points"},
    {"no_neighbours",
     row(11, "  - @{name: A, family: sph, kernel: wendland_c2, smoothing_length: 0.2}"),
     "'A' on layout 'lattice' with resolution 4: point 0 has no neighbour"},
    {"no_mps_neighbours", row(12, "  - @{name: B, family: mps, smoothing_length: 1}"),
     "'B' on layout 'lattice' with resolution 4: particle 0 has no neighbour"},
    {"least_squares_of_too_few",
     row(12, "  - @{name: B, family: least_squares, degree: 3, smoothing_length: 1}"),
     "particle 0 has 4 neighbours, which do not fix a polynomial of degree 3 with 9 unknowns"},
    {"corrected_sph_of_too_few",
     row(12, "  - @{name: B, family: corrected_sph, kernel: wendland_c2, smoothing_length: 0.55}"),
     "particle 0 has 4 neighbours, and their moment matrix is singular"},
    {"differences_of_jittered_points", row(12, "  - @{name: B, family: finite_difference}"),
     "'B' on layout 'jittered' with resolution 4: particle 0 has no point on each side"},
    {"differences_at_free_ends",
     edited({{9, "extension: {type: none}"}, {12, "  - @{name: B, family: finite_difference}"}}),
     "'B' on layout 'lattice' with resolution 4: particle 0 has no point on each side"},
    {"differences_at_free_ends_of_a_line",
     "name: base\ndimension: 1\ndomain: {lower: [0], upper: [1]}\nfield: \"x\"\n"
     "layouts: [geometric]\nresolutions: [4]\nextension: {type: none}\n"
     "operators: [@finite_difference]\n",
     "particle 0 has no point on each side"},
    {"no_corner_of_a_flat_cell",
     "name: base\ndimension: 2\ndomain: {lower: [0, 0], upper: [1, 0.13]}\nfield: \"x*y\"\n"
     "layouts: [lattice]\nresolutions: [2]\noperators: [@finite_difference]\n",
     "particle 0 lacks a corner of its lattice cell"},
    {"no_vorticity", edited({{6, "vorticity: \"x - 0.125\""}, {12, "  - @vortex_blob.gauss"}}),
     "the vorticity of particle 0 is 0"}};
INSTANTIATE_TEST_SUITE_P(Table, BrokenStudy, testing::ValuesIn(broken), by_label);

/// A study of the file p.csv, which has these lines; `@` as above.
ScenarioCase of_file(const std::string& label, const std::string& points,
                     const std::string& sentence,
                     const std::string& layouts = "[@{type: file, path: p.csv}]",
                     const std::string& operators = "[sph.wendland_c2]") {
  return {label,
          "name: base\ndimension: 2\nfield: \"x*y\"\nlayouts: " + layouts +
              "\noperators: " + operators + "\n#" + points,
          sentence};
}

/// The points stand as a comment at the end of the case's text.
class BadPoints : public testing::TestWithParam<ScenarioCase> {};
TEST_P(BadPoints, AreRefused) {
  const Marked marked = unmark(GetParam().text);
  const auto comment = marked.text.find('#');
  const Workspace workspace(marked.text.substr(0, comment));
  if (const auto points = marked.text.substr(comment + 1); !points.empty())
    write(workspace / "p.csv", points);
  const std::string behind_place = marked.place.empty() ? "" : ": ";
  const Refusal refusal{"scenario.yaml" + marked.place + behind_place, GetParam().sentence};
  for (const auto& fault : faults(workspace.mote(measuring), refusal)) ADD_FAILURE() << fault;
  // At most the check-up that says why the points are bad.
  for (const char* name : {"study.csv", "study.md", "points.csv"})
    EXPECT_FALSE(fs::exists(workspace / "out" / name)) << name;
}

const std::vector<ScenarioCase> bad_points{
    of_file("same_place", "x,y\n0,0\n0,1\n1,0\n0,1\n0,0\n",
            "the points 0 and 4 lie at the same place"),
    of_file("of_a_line", "x\n0\n1\n2\n", "p.csv: its points have 1 coordinate, the study has 2"),
    of_file("of_space", "x,y,z\n0,0,1\n1,0,2\n", "its points have 3 coordinates, the study has 2"),
    of_file("volume", "x,y,volume\n0,0,1\n1,0,-2\n1,1,-3\n", "volume of point 1 must be positive"),
    of_file("mass", "x,y,mass\n0,0,1\n1,0,1\n1,1,0\n", "the mass of point 2 must be positive"),
    of_file("density", "x,y,density\n0,0,-1\n1,0,1\n", "the density of point 0 must be positive"),
    of_file("nan", "x,y\n0,0\n0,1\n1,nan\n", "p.csv:4:3: y of point 2 is not a number"),
    of_file("infinite", "x,y\n0,0\ninf,1\n", "p.csv:3:1: x of point 1 is infinite"),
    of_file("field_too_long", "x,y,field\n0,0,1\n1,0,1,2\n", "p.csv:3:1: this row has 4 cells"),
    of_file("field_too_short", "x,y,field\n0,0,1\n1,0\n", "p.csv:3:1: this row has 2 cells"),
    of_file("no_x", "a,y\n0,0\n1,0\n", "there is no column x"),
    of_file("word", "x,y\n0,zero\n1,0\n", "y of point 0 must be a number, not 'zero'"),
    of_file("empty", "\n", "p.csv"),
    of_file("missing", "", "p.csv: there is no such file"),
    of_file("of_another_kind", "", "scenario.yaml: a file of points must end in .csv",
            "[@{type: file, path: scenario.yaml}]"),
    of_file("too_far_apart", "x,y,volume\n0,0,0.01\n1,0,0.01\n1,1,0.01\n",
            "'sph.wendland_c2' on layout 'p': point 0 has no neighbour",
            "[{type: file, path: p.csv}]", "[@sph.wendland_c2]"),
    of_file("too_few", "x,y,volume\n0,0,1\n1,0,1\n1,1,1\n",
            "helps; the check-up of the points is in out/check_up.csv",
            "[{type: file, path: p.csv}]", "[@{family: least_squares, degree: 2}]"),
    of_file("no_lattice", "x,y,volume\n0,0,1\n1,0,1\n1,1,1\n",
            "particle 0 has no point on each side", "[{type: file, path: p.csv}]",
            "[@finite_difference]")};
INSTANTIATE_TEST_SUITE_P(Table, BadPoints, testing::ValuesIn(bad_points), by_label);

/// Control: the good study passes, and leaves what the bad ones must not.
TEST(GoodStudy, RunsWithoutAWord) {
  const Workspace workspace(good_study);
  const Outcome outcome = workspace.mote(measuring);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
  for (const char* name : {"study.csv", "study.md", "points.csv", "study.yaml"})
    EXPECT_TRUE(fs::exists(workspace / "out" / name)) << name;
}

TEST(GoodStudy, OfPointsRunsWithoutAWord) {
  const Workspace workspace(
      "name: base\ndimension: 2\nfield: \"x*y\"\nlayouts: [{type: file, path: p.csv}]\n"
      "operators: [sph.wendland_c2]\noutput: {picture: false}\n");
  write(workspace / "p.csv", "x,y\n0,0\n0,1\n1,0\n1,1\n");
  const Outcome outcome = workspace.mote(measuring);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

}  // namespace
}  // namespace mote::test
