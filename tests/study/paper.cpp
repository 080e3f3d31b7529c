// Studies of sections 5 and 6.2 of Isshiki (2014), every number recomputed from the printed
// formulas and points.csv alone.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "study/csv_table.hpp"
#include "study/printed_sums.hpp"
#include "study/written_study.hpp"
#include "support/agreement.hpp"

namespace mote::test {
namespace {

/// One of the paper's methods: its operator in a study file, and its sums as printed.
struct Method {
  std::string name, options, of = "mean";
  int beyond;  ///< N_end_cor
  std::function<PrintedDerivatives(const PrintedLine&)> printed;
};

Method sph(const std::string& name, const std::string& kernel, const PrintedWeight& weight,
           double length, const std::string& of) {
  return {name + "_" + of,
          fmt::format("family: sph, kernel: {}, smoothing_length: {}", kernel, length), of, 8,
          [=](const PrintedLine& line) {
            return printed_sph(line, weight, {length, of});
          }};
}

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const char* of : {"mean", "scatter", "gather"}) {
    all.push_back(sph("SPH0", "gauss", gauss, 1, of));
    all.push_back(sph("SPH1", "lucy", lucy, 8, of));
    all.push_back(sph("SPH2", "cubic_spline", cubic, 8, of));
    all.push_back({std::string("MPS_") + of, "family: mps, smoothing_length: 2", of, 2,
                   [=](const PrintedLine& line) {
                     return printed_mps(line, {2, of});
                   }});
  }
  return all;
}

/// The conditions of one of the paper's figures.
struct Conditions {
  int N = 40;
  bool varying_density = false;
  std::string extension = "formula";
};

std::string study_of(const Conditions& given, const std::vector<Method>& methods) {
  std::string text = fmt::format(
      "name: paper\ndimension: 1\nconstants: {{L: 4}}\ndomain: {{lower: [0], upper: [L]}}\n"
      "field: \"sin(2*pi*x/L)\"\ndensity: \"{}\"\nresolutions: [{}]\nseed: 3\n"
      "layouts: [regular, algebraic, geometric, random, sinusoidal]\n"
      "extension: {{type: {}}}\noperators:\n",
      given.varying_density ? "1 + (x/L)^2" : "1", given.N, given.extension);
  for (const Method& method : methods)
    text += fmt::format("  - {{name: {}, {}, length: {}, extension_cells: {}}}\n", method.name,
                        method.options, method.of, method.beyond);
  return text;
}

PrintedLine line_of(const std::string& mesh, const Conditions& given, int beyond) {
  PrintedLine line{printed_cells({mesh, given.N, 0, 4, 3, given.extension, beyond}),
                   beyond,
                   beyond + given.N,
                   {},
                   {}};
  for (const Wide x : line.cells.centre) {
    line.field.push_back(std::sin(2 * std::numbers::pi_v<Wide> * x / 4));
    line.density.push_back(given.varying_density ? 1 + (x / 4) * (x / 4) : 1);
  }
  return line;
}

/// Whether the rows of a case hold what is printed: places, fields and exact derivatives but for
/// rounding. A second derivative takes differences of terms that are some (h/dx)^2 larger, and some
/// 1e4 roundings (2e-12) are far below the limit.
testing::AssertionResult are_printed(const std::vector<CsvTable::Row>& rows,
                                     const PrintedLine& line, const PrintedDerivatives& printed) {
  constexpr double limit = 1e-9;
  std::vector<Wide> x, field, gradient, laplacian;
  const Wide k = 2 * std::numbers::pi_v<Wide> / 4;
  for (int i = line.begin; i < line.end; ++i) {
    x.push_back(line.cells.centre[i]);
    field.push_back(line.field[i]);
    gradient.push_back(k * std::cos(k * x.back()));
    laplacian.push_back(-k * k * std::sin(k * x.back()));
  }
  const auto column = [&](const std::string& name, const std::vector<Wide>& values, double within) {
    return agree(numbers(rows, name), values, within) << " in " << name;
  };
  if (auto right = column("x", x, 1e-13); !right) return right;
  if (auto right = column("field", field, 1e-12); !right) return right;
  if (auto right = column("gradient_x_exact", gradient, 1e-12); !right) return right;
  if (auto right = column("laplacian_exact", laplacian, 1e-12); !right) return right;
  if (auto right = column("gradient_x_computed", printed.gradient, limit); !right) return right;
  return column("laplacian_computed", printed.laplacian, limit);
}

CsvTable points_of(const Conditions& given, const std::vector<Method>& methods) {
  const WrittenStudy written(study_of(given, methods));
  written.run();
  return CsvTable(read(written.folder / "points.csv"));
}

void expect_printed(const Conditions& given, const std::vector<Method>& methods) {
  const CsvTable points = points_of(given, methods);
  for (const char* mesh : {"regular", "algebraic", "geometric", "random", "sinusoidal"})
    for (const Method& method : methods) {
      const auto rows = points.where({{"layout", mesh}, {"operator", method.name}});
      const PrintedLine line = line_of(mesh, given, method.beyond);
      EXPECT_TRUE(are_printed(rows, line, method.printed(line))) << method.name << " on " << mesh;
    }
}

TEST(PaperStudy, OfSection6IsAsPrinted) { expect_printed({}, methods()); }

TEST(PaperStudy, OfSection6WithVaryingDensityIsAsPrinted) {
  expect_printed({.varying_density = true}, methods());
}

TEST(PaperStudy, OfSection5IsAsPrinted) {
  for (const bool varying : {false, true})
    expect_printed({.N = 80, .varying_density = varying}, {sph("SPH0", "gauss", gauss, 1, "mean")});
}

TEST(PaperStudy, IsAsPrintedWithOtherEnds) {
  for (const char* extension : {"constant", "mirror", "periodic"})
    expect_printed({.varying_density = true, .extension = extension}, methods());
}

/// Section 5.1.1, figure 2(a): without cells beyond them the ends have large errors.
TEST(PaperStudy, OfFreeEndsIsAsPrinted) {
  std::vector<Method> free = methods();
  for (Method& method : free) method.beyond = 0;
  expect_printed({}, free);
}

TEST(PaperStudy, CheckTellsMethodsMeshesAndLengthsApart) {
  const std::vector<Method> all = methods();
  const CsvTable points = points_of({}, all);
  for (const Method& method : all)
    for (const Method& other : all) {
      const auto rows = points.where({{"layout", "geometric"}, {"operator", method.name}});
      const PrintedLine line = line_of("geometric", {}, other.beyond);
      EXPECT_EQ(static_cast<bool>(are_printed(rows, line, other.printed(line))),
                method.name == other.name)
          << method.name << " and " << other.name;
    }
}

TEST(PaperStudy, CheckNoticesAnotherDensityOrNumberOfCellsBeyond) {
  const Method method = sph("SPH0", "gauss", gauss, 1, "mean");
  const CsvTable points = points_of({}, {method});
  const auto rows = points.where({{"layout", "geometric"}});
  const auto printed = [&](const PrintedLine& line) {
    return static_cast<bool>(are_printed(rows, line, method.printed(line)));
  };
  EXPECT_TRUE(printed(line_of("geometric", {}, 8)));
  EXPECT_FALSE(printed(line_of("geometric", {}, 2)));
  EXPECT_FALSE(printed(line_of("geometric", {.varying_density = true}, 8)));
}

}  // namespace
}  // namespace mote::test
