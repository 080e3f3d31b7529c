// The rows of study.csv, recomputed from points.csv.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "study/csv_table.hpp"
#include "study/written_study.hpp"

namespace mote::test {
namespace {

/// A study, and how its points lie.
struct Layout {
  int dimension;
  std::vector<double> size;  ///< of the domain, along x first
  int margin;
};

/// Whether point i of n along x lies more than the margin from every side.
bool is_interior(const Layout& layout, int i, int n) {
  for (int d = 0; d < layout.dimension; ++d) {
    const int count = static_cast<int>(std::lround(n * layout.size[d] / layout.size[0]));
    const int k = i % count;
    if (k < layout.margin || k >= count - layout.margin) return false;
    i /= count;
  }
  return true;
}

/// The errors of all components of a quantity, and the exact values, at the points that count.
struct Errors {
  std::vector<long double> error, exact;
};

Errors errors_of(const std::vector<CsvTable::Row>& rows, const std::string& quantity,
                 const std::function<bool(int)>& counts) {
  Errors errors;
  for (const auto& [name, unused] : rows.front()) {
    if (!name.starts_with(quantity) || !name.ends_with("_computed")) continue;
    const std::string exact = name.substr(0, name.size() - 8) + "exact";
    for (const auto& row : rows) {
      if (!counts(std::stoi(row.at("index")))) continue;
      errors.exact.push_back(std::stold(row.at(exact)));
      errors.error.push_back(std::stold(row.at(name)) - errors.exact.back());
    }
  }
  return errors;
}

long double size_of(const std::vector<long double>& values, const std::string& norm) {
  long double sum = 0, squares = 0, largest = 0;
  for (const long double value : values) {
    sum += std::abs(value);
    squares += value * value;
    largest = std::max(largest, std::abs(value));
  }
  return norm.ends_with("l1") ? sum : (norm.ends_with("l2") ? std::sqrt(squares) : largest);
}

/// What study.csv should say, from points.csv.
long double expected_error(const CsvTable& points, const CsvTable::Row& row, const Layout& layout) {
  const auto rows = points.where({{"layout", row.at("layout")},
                                  {"resolution", row.at("resolution")},
                                  {"operator", row.at("operator")}});
  const bool interior = row.at("norm").starts_with("interior_");
  const auto [error, exact] = errors_of(rows, row.at("quantity"), [&](int i) {
    return !interior || is_interior(layout, i, std::stoi(row.at("resolution")));
  });
  return size_of(error, row.at("norm")) / size_of(exact, row.at("norm"));
}

/// The row before of the same case, if there is one.
const CsvTable::Row* coarser(const CsvTable& study, const CsvTable::Row& row) {
  const CsvTable::Row* found = nullptr;
  for (const auto& other : study.rows) {
    bool same = std::stoi(other.at("resolution")) < std::stoi(row.at("resolution"));
    for (const char* name : {"layout", "operator", "quantity", "norm"})
      same = same && other.at(name) == row.at(name);
    if (same) found = &other;
  }
  return found;
}

/// Which rows of study.csv do not follow from points.csv: a sum of n terms errs by n roundings.
int wrong_rows(const CsvTable& study, const CsvTable& points, const Layout& layout) {
  int wrong = 0;
  for (const auto& row : study.rows) {
    const long double error = std::stold(row.at("error"));
    const long double expected = expected_error(points, row, layout);
    bool right = std::abs(error - expected) <= 1e-12L * expected;
    if (const auto* before = coarser(study, row)) {
      const auto ratio = [&](const std::string& name) {
        return std::log(std::stold(row.at(name)) / std::stold(before->at(name)));
      };
      const long double order = -ratio("error") / ratio("resolution");
      right =
          right && std::abs(std::stold(row.at("order")) - order) <= 1e-12L * (1 + std::abs(order));
    } else {
      right = right && row.at("order").empty();
    }
    wrong += !right;
  }
  return wrong;
}

const std::string norms =
    "norms: [l1, l2, max, interior_l1, interior_l2, interior_max]\n"
    "extension: {type: none}\n";

const Layout line{1, {4}, 3}, plane{2, {1, 1.5}, 2}, space{3, {1, 0.75, 1.25}, 1};

const std::string on_a_line =
    "name: n\ndimension: 1\ndomain: {lower: [-1], upper: [3]}\nfield: \"exp(x/2)\"\nmargin: 3\n"
    "layouts: [regular, geometric, jittered]\nresolutions: [12, 20, 50]\n"
    "operators: [sph.gauss, mps]\n" +
    norms;

const std::string in_the_plane =
    "name: n\ndimension: 2\ndomain: {lower: [0, 0], upper: [1, 1.5]}\nfield: \"exp(x)*y\"\n"
    "layouts: [lattice, jittered]\nresolutions: [8, 14]\nvector_field: [\"x^3*y\", \"x^2 - "
    "exp(y)\"]\n"
    "margin: 2\noperators: [sph.wendland_c2, mps]\n" +
    norms;

const std::string in_space =
    "name: n\ndimension: 3\ndomain: {lower: [0, 0, 0], upper: [1, 0.75, 1.25]}\nmargin: 1\n"
    "field: \"exp(x)*y + z^2\"\nlayouts: [jittered]\nresolutions: [4, 8]\n"
    "vector_field: [\"x*y\", \"x^2 - z\", \"exp(y)\"]\noperators: [sph.wendland_c2]\n" +
    norms;

struct Tables {
  CsvTable study, points;
  explicit Tables(const std::string& text) : Tables(WrittenStudy(text)) {}

 private:
  explicit Tables(const WrittenStudy& written)
      : study(study_csv(written.run())), points(read(written.folder / "points.csv")) {}
};

TEST(StudyRows, FollowFromThePoints) {
  const Tables of_line(on_a_line), of_plane(in_the_plane), of_space(in_space);
  EXPECT_EQ(of_line.study.rows.size(), 3u * 3 * 2 * 2 * 6);
  EXPECT_EQ(of_plane.study.rows.size(), 2u * 2 * 2 * 5 * 6);
  EXPECT_EQ(of_space.study.rows.size(), 2u * 5 * 6);
  EXPECT_EQ(wrong_rows(of_line.study, of_line.points, line), 0);
  EXPECT_EQ(wrong_rows(of_plane.study, of_plane.points, plane), 0);
  EXPECT_EQ(wrong_rows(of_space.study, of_space.points, space), 0);
}

/// The norms that know the margin are wrong with another, but for a few largest errors that lie
/// further inside; the others stay right.
TEST(StudyRows, CheckNoticesAnotherMargin) {
  const Tables tables(on_a_line);
  const Layout other{1, {4}, 2};
  CsvTable interior = tables.study, everywhere = tables.study;
  std::erase_if(interior.rows, [](const auto& row) { return !row.at("norm").starts_with("int"); });
  std::erase_if(everywhere.rows, [](const auto& row) { return row.at("norm").starts_with("int"); });
  EXPECT_EQ(wrong_rows(everywhere, tables.points, other), 0);
  EXPECT_GE(wrong_rows(interior, tables.points, other), 3 * 3 * 2 * 2 * 2);
}

/// Point 5 of 12 is an interior one: all six norms of its case feel it.
TEST(StudyRows, CheckNoticesAWrongPoint) {
  Tables tables(on_a_line);
  tables.points.rows[5].at("gradient_x_computed") = "1e6";
  EXPECT_EQ(wrong_rows(tables.study, tables.points, line), 6);
}

TEST(StudyRows, HaveNoOrderWithoutAnError) {
  const WrittenStudy written(
      "name: n\ndimension: 1\ndomain: {lower: [0], upper: [1]}\nfield: \"3\"\nlayouts: [lattice]\n"
      "resolutions: [5, 10]\noperators: [mps]\n");
  for (const StudyRow& row : written.run().rows) {
    EXPECT_EQ(row.error, 0);
    EXPECT_FALSE(row.order.has_value());
  }
}

}  // namespace
}  // namespace mote::test
