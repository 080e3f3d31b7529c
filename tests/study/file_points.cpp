#include "mote/study/file_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mote/particles/failure.hpp"
#include "study/written_study.hpp"
#include "support/agreement.hpp"
#include "support/brute_force.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

/// Points of a jittered square lattice, a column each; the density by formula is 1 + x.
struct Columns {
  std::map<std::string, std::vector<double>> values;

  Columns() {
    Draws draws(12);
    for (int k = 0; k < 64; ++k) {
      values["x"].push_back(0.1 * (k % 8 + draws.uniform(-0.2, 0.2)));
      values["y"].push_back(0.1 * (k / 8 + draws.uniform(-0.2, 0.2)));
      for (const char* name : {"mass", "volume", "density", "field"})
        values[name].push_back(draws.uniform(0.5, 2));
    }
  }

  std::string csv(const std::vector<std::string>& names) const {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ",") + name;
    for (std::size_t i = 0; i < values.at("x").size(); ++i)
      for (const auto& name : names)
        text += fmt::format("{}{:.17g}", name == names.front() ? "\n" : ",", values.at(name)[i]);
    return text + "\n";
  }
};

StudyPoints<2> points_of(const std::string& csv,
                         const std::string& density = "density: \"1 + x\"\n") {
  const WrittenStudy written("name: own\ndimension: 2\nfield: \"x\"\n" + density +
                             "vorticity: \"2 - y\"\n"
                             "layouts: [{type: file, path: p.csv}]\noperators: [sph.gauss]\n");
  write(written.folder / "p.csv", csv);
  return file_points<2>(
      {written.study, written.catalogue, written.study.layouts[0], 0, 0, written.folder.path()},
      ExactField(written.study));
}

/// h^2 over the sum of Wendland's C2 kernel in the plane, 7/(4 pi) (1 - s)^4 (1 + 4 s) with
/// s = r/(2 h), where h is twice the mean distance of the four nearest.
std::vector<long double> volumes_by_spacing(const Points<2>& points) {
  std::vector<long double> volumes;
  for (Index i = 0; i < points.size(); ++i) {
    std::vector<long double> r;
    for (Index j = 0; j < points.size(); ++j) r.push_back(wide_distance(points, i, j));
    auto nearest = r;
    std::ranges::sort(nearest);
    const long double h = 2 * (nearest[1] + nearest[2] + nearest[3] + nearest[4]) / 4;
    long double sum = 0;
    for (const long double distance : r)
      if (const long double s = distance / (2 * h); s < 1)
        sum += 7 / (4 * std::numbers::pi_v<long double>)*std::pow(1 - s, 4) * (1 + 4 * s);
    volumes.push_back(h * h / sum);
  }
  return volumes;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

struct Amounts {
  std::vector<long double> mass, volume, density;
};

/// What the interface says of a file with these columns.
Amounts expected(const Columns& columns, const std::vector<std::string>& names,
                 const Points<2>& points) {
  const auto wide = [&](const std::string& name) {
    const auto& values = columns.values.at(name);
    return std::vector<long double>(values.begin(), values.end());
  };
  Amounts result{wide("mass"), wide("volume"), wide("density")};
  const bool mass = has(names, "mass"), volume = has(names, "volume"),
             density = has(names, "density");
  const auto spaced = volumes_by_spacing(points);
  for (std::size_t i = 0; i < spaced.size(); ++i) {
    if (!density)
      result.density[i] =
          mass && volume ? result.mass[i] / result.volume[i] : 1.0L + columns.values.at("x")[i];
    if (!volume) result.volume[i] = mass ? result.mass[i] / result.density[i] : spaced[i];
    if (!mass) result.mass[i] = result.volume[i] * result.density[i];
  }
  return result;
}

/// Whether points have those amounts. The sum over a kernel has some 50 terms.
testing::AssertionResult have(const Points<2>& points, const Amounts& amounts) {
  std::vector<double> volume;
  for (const double length : points.length) volume.push_back(length * length);
  if (auto right = agree(volume, amounts.volume, 1e-13); !right) return right << " (volume)";
  if (auto right = agree(points.mass, amounts.mass, 1e-13); !right) return right << " (mass)";
  return agree(points.density, amounts.density, 1e-13) << " (density)";
}

std::vector<std::vector<std::string>> combinations() {
  std::vector<std::vector<std::string>> all;
  for (int bits = 0; bits < 16; ++bits) {
    std::vector<std::string> names{"x", "y"};
    int bit = 1;
    for (const char* name : {"mass", "volume", "density", "field"}) {
      if (bits & bit) names.emplace_back(name);
      bit *= 2;
    }
    all.push_back(names);
  }
  return all;
}

TEST(FilePoints, FillInWhatTheFileLacks) {
  const Columns columns;
  for (const auto& names : combinations()) {
    const auto found = points_of(columns.csv(names));
    EXPECT_TRUE(have(found.points, expected(columns, names, found.points)))
        << columns.csv(names).substr(0, 40);
    EXPECT_EQ(found.field,
              has(names, "field") ? columns.values.at("field") : std::vector<double>{});
    EXPECT_EQ(found.points.receivers, 64);
    EXPECT_TRUE(found.interior.empty());
  }
}

TEST(FilePoints, HaveTheVorticityOfTheFormula) {
  const Columns columns;
  const auto points = points_of(columns.csv({"x", "y", "volume"})).points;
  for (std::size_t i = 0; i < 64; ++i) {
    const double vorticity = 2 - columns.values.at("y")[i];
    EXPECT_NEAR(points.vorticity[i], vorticity, 1e-15);
    EXPECT_NEAR(points.circulation[i], vorticity * columns.values.at("volume")[i], 1e-14);
  }
}

TEST(FilePoints, SayWhereVolumesComeFrom) {
  const Columns columns;
  using Remarks = std::vector<std::string>;
  const auto remarks = [&](const std::vector<std::string>& names) {
    return points_of(columns.csv(names)).remarks;
  };
  EXPECT_EQ(remarks({"x", "y", "volume"}), Remarks{});
  EXPECT_THAT(remarks({"x", "y"}), testing::ElementsAre(testing::StartsWith(
                                       "p.csv: volumes follow from how closely the points lie; ")));
  EXPECT_EQ(remarks({"x", "y", "mass"}), Remarks{"p.csv: volumes are mass over density"});
  EXPECT_EQ(remarks({"x", "y", "volume", "field"}),
            Remarks{"p.csv: the field's values are the file's own column"});
}

// A default density is not the points' own: only one that the study states makes volumes of masses.
TEST(FilePoints, OfMassAloneHaveTheDensityThatTheirSpacingGives) {
  const Columns columns;
  const auto found = points_of(columns.csv({"x", "y", "mass"}), "").points;
  const auto volumes = volumes_by_spacing(found);
  for (std::size_t i = 0; i < volumes.size(); ++i)
    EXPECT_NEAR(found.density[i] * static_cast<double>(volumes[i]), columns.values.at("mass")[i],
                1e-12);
}

TEST(FilePoints, CloserThanAMillionthOfTheSpacingAreRefused) {
  EXPECT_NO_THROW(points_of("x,y\n0,0\n1,0\n0,1\n1,1\n1e-3,0\n"));
  EXPECT_THROW(points_of("x,y\n0,0\n1,0\n0,1\n1,1\n1e-9,0\n"), InputError);
}

/// Far from the sides, of a lattice: the kernel's sum is the integral but for its high harmonics.
TEST(FilePoints, OnALatticeHaveTheVolumesOfItsCells) {
  std::string csv = "x,y\n";
  for (int k = 0; k < 441; ++k) csv += fmt::format("{},{}\n", 0.5 * (k % 21), 0.5 * (k / 21));
  const auto points = points_of(csv).points;
  EXPECT_NEAR(points.length[220], 0.5, 0.5 * 0.002);
  EXPECT_GT(points.length[0], 0.5 * 1.2);  // a corner sees a quarter of its neighbours
}

TEST(FilePoints, ChecksNoticeOtherAmounts) {
  const Columns columns;
  const std::vector<std::string> names{"x", "y", "mass", "volume"};
  auto points = points_of(columns.csv(names)).points;
  const Amounts right = expected(columns, names, points);
  ASSERT_TRUE(have(points, right));
  EXPECT_FALSE(have(points, expected(columns, {"x", "y", "mass"}, points)));
  EXPECT_FALSE(have(points, expected(columns, {"x", "y", "volume"}, points)));
  points.mass[5] *= 1 + 1e-9;
  EXPECT_FALSE(have(points, right));
}

TEST(FilePoints, AreRefusedWithTheFirstThatOffends) {
  const auto refusal = [](const std::string& csv) -> std::string {
    try {
      points_of(csv);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto says = [&](const std::string& csv, const std::string& sentence) {
    return refusal(csv).find(sentence) != std::string::npos;
  };
  EXPECT_TRUE(says("x,y\n0,0\n1,0\n0,1\n1,0\n0,0\n", "the points 0 and 4 lie at the same place"));
  EXPECT_TRUE(says("x,y\n3,0\n1,0\n0,1\n1,0\n1,0\n", "the points 1 and 3 lie at the same place"));
  EXPECT_TRUE(says("x,y\n0,0\n-0.0,0\n", "the points 0 and 1 lie at the same place"));
  EXPECT_TRUE(says("x,y,mass\n0,0,1\n1,0,0\n0,1,-1\n", "mass of point 1 must be positive"));
  EXPECT_TRUE(says("x,y,volume\n0,0,1\n1,0,1\n0,1,-2\n", "volume of point 2"));
  EXPECT_TRUE(says("x,y,density\n0,0,1\n1,0,-3\n", "density of point 1"));
  EXPECT_TRUE(says("x\n0\n1\n", "1 coordinate, the study has 2"));
  EXPECT_TRUE(says("x,y,z\n0,0,0\n1,1,1\n", "3 coordinates, the study has 2"));
  EXPECT_TRUE(says("x,y,mass\n-1,0,1\n1,1,1\n", "the density must be positive, and is 0"));
  EXPECT_EQ(refusal("x,y\n0,0\n1,0\n0,1\n"), "");
}

}  // namespace
}  // namespace mote::test
