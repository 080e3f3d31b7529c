#include "mote/study/exact_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "mote/particles/failure.hpp"
#include "study/written_study.hpp"
#include "support/agreement.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

/// A study of a field in so many dimensions, and more lines.
std::string study_of(int dimension, const std::string& field, const std::string& more = "") {
  const std::string ends[] = {"{lower: [0], upper: [1]}", "{lower: [0, 0], upper: [1, 1]}",
                              "{lower: [0, 0, 0], upper: [1, 1, 1]}"};
  return "name: fields\ndimension: " + std::to_string(dimension) +
         "\nconstants: {k: 1.5}\ndomain: " + ends[dimension - 1] + "\nfield: \"" + field +
         "\"\nlayouts: [lattice]\nresolutions: [4]\noperators: [sph.gauss]\n" + more;
}

using Values = std::vector<double>;
using ByHand = std::function<Values(double x, double y, double z)>;

constexpr int places = 50;

Values positions(int dimension) {
  return Draws(7).uniform(static_cast<std::size_t>(places * dimension), 0.2, 1.8);
}

/// Whether values at those places are the ones by hand. The derivatives by symbols are the same
/// formulas in another order of work: some roundings of the largest.
testing::AssertionResult are(const Values& values, int dimension, const ByHand& by_hand) {
  const Values x = positions(dimension);
  Values expected;
  for (int i = 0; i < places; ++i) {
    const auto at = [&](int d) { return d < dimension ? x[i * dimension + d] : 0; };
    const Values here = by_hand(at(0), at(1), at(2));
    expected.insert(expected.end(), here.begin(), here.end());
  }
  return agree(values, expected, 1e-13);
}

/// The exact values of a quantity of a study.
Values exact(const std::string& text, int dimension, const std::string& quantity) {
  const WrittenStudy written(text);
  return ExactField(written.study).exact(quantity, positions(dimension));
}

const std::string on_a_line =
    study_of(1, "sin(k*x)*exp(x)", "quantities: [gradient, divergence, hessian, laplacian]\n");

const ByHand slope = [](double x, double, double) {
  return Values{std::exp(x) * (1.5 * std::cos(1.5 * x) + std::sin(1.5 * x))};
};
const ByHand curvature = [](double x, double, double) {
  return Values{std::exp(x) * (3 * std::cos(1.5 * x) + (1 - 2.25) * std::sin(1.5 * x))};
};

TEST(ExactField, HasTheDerivativesByHandOnALine) {
  EXPECT_TRUE(are(exact(on_a_line, 1, "gradient"), 1, slope));
  EXPECT_TRUE(are(exact(on_a_line, 1, "divergence"), 1, slope));
  EXPECT_TRUE(are(exact(on_a_line, 1, "hessian"), 1, curvature));
  EXPECT_TRUE(are(exact(on_a_line, 1, "laplacian"), 1, curvature));
}

TEST(ExactField, CheckNoticesAnotherDerivative) {
  EXPECT_FALSE(are(exact(on_a_line, 1, "gradient"), 1, curvature));
  EXPECT_FALSE(are(exact(on_a_line, 1, "laplacian"), 1, [](double x, double, double) {
    return Values{std::exp(x) * (3 * std::cos(1.5 * x) + (1 - 2.25001) * std::sin(1.5 * x))};
  }));
}

const std::string in_the_plane =
    study_of(2, "x^3*y^2 - cos(x*y)", "vector_field: [\"x^2*y\", \"sin(x)*y^3\"]\n");

TEST(ExactField, HasTheDerivativesByHandInThePlane) {
  const auto is = [](const std::string& quantity, const ByHand& by_hand) {
    return are(exact(in_the_plane, 2, quantity), 2, by_hand);
  };
  EXPECT_TRUE(is("gradient", [](double x, double y, double) {
    return Values{3 * x * x * y * y + y * std::sin(x * y), 2 * x * x * x * y + x * std::sin(x * y)};
  }));
  const auto xx = [](double x, double y) { return 6 * x * y * y + y * y * std::cos(x * y); };
  const auto yy = [](double x, double y) { return 2 * x * x * x + x * x * std::cos(x * y); };
  EXPECT_TRUE(is("hessian", [&](double x, double y, double) {
    const double xy = 6 * x * x * y + std::sin(x * y) + x * y * std::cos(x * y);
    return Values{xx(x, y), xy, xy, yy(x, y)};
  }));
  EXPECT_TRUE(
      is("laplacian", [&](double x, double y, double) { return Values{xx(x, y) + yy(x, y)}; }));
  EXPECT_TRUE(is("divergence", [](double x, double y, double) {
    return Values{2 * x * y + 3 * std::sin(x) * y * y};
  }));
  EXPECT_TRUE(is(
      "curl", [](double x, double y, double) { return Values{std::cos(x) * y * y * y - x * x}; }));
}

const std::string in_space =
    study_of(3, "x*y^2*z^3 + sin(x)*z", "vector_field: [\"y*z^2\", \"sin(x*z)\", \"x*y^2*z\"]\n");

TEST(ExactField, HasTheDerivativesByHandInSpace) {
  const auto is = [](const std::string& quantity, const ByHand& by_hand) {
    return are(exact(in_space, 3, quantity), 3, by_hand);
  };
  EXPECT_TRUE(is("gradient", [](double x, double y, double z) {
    return Values{y * y * z * z * z + std::cos(x) * z, 2 * x * y * z * z * z,
                  3 * x * y * y * z * z + std::sin(x)};
  }));
  EXPECT_TRUE(is("hessian", [](double x, double y, double z) {
    const double xy = 2 * y * z * z * z, xz = 3 * y * y * z * z + std::cos(x),
                 yz = 6 * x * y * z * z;
    return Values{-std::sin(x) * z, xy, xz, xy, 2 * x * z * z * z, yz, xz, yz, 6 * x * y * y * z};
  }));
  EXPECT_TRUE(is("laplacian", [](double x, double y, double z) {
    return Values{-std::sin(x) * z + 2 * x * z * z * z + 6 * x * y * y * z};
  }));
  EXPECT_TRUE(is("divergence", [](double x, double y, double) { return Values{x * y * y}; }));
  EXPECT_TRUE(is("curl", [](double x, double y, double z) {
    const double cosine = std::cos(x * z);
    return Values{2 * x * y * z - x * cosine, 2 * y * z - y * y * z, z * cosine - z * z};
  }));
}

TEST(ExactField, HasItsValuesPointByPoint) {
  const WrittenStudy written(in_space + "density: \"1 + x*y\"\nvorticity: \"z\"\n");
  const ExactField fields(written.study);
  const Values x = positions(3);
  EXPECT_TRUE(are(fields.field(x), 3, [](double x, double y, double z) {
    return Values{x * y * y * z * z * z + std::sin(x) * z};
  }));
  EXPECT_TRUE(are(fields.vector_field(x), 3, [](double x, double y, double z) {
    return Values{y * z * z, std::sin(x * z), x * y * y * z};
  }));
  EXPECT_TRUE(
      are(fields.density(x), 3, [](double x, double y, double) { return Values{1 + x * y}; }));
  EXPECT_TRUE(are(fields.vorticity(x), 3, [](double, double, double z) { return Values{z}; }));
}

TEST(ExactField, NamesItsComponents) {
  using Names = std::vector<std::string>;
  const WrittenStudy line(on_a_line), plane(in_the_plane), space(in_space);
  const auto names = [](const WrittenStudy& written, const std::string& quantity) {
    return ExactField(written.study).components(quantity);
  };
  EXPECT_EQ(names(line, "gradient"), Names{"_x"});
  EXPECT_EQ(names(line, "hessian"), Names{"_xx"});
  EXPECT_EQ(names(plane, "gradient"), (Names{"_x", "_y"}));
  EXPECT_EQ(names(plane, "curl"), Names{""});
  EXPECT_EQ(names(plane, "hessian"), (Names{"_xx", "_xy", "_yx", "_yy"}));
  EXPECT_EQ(names(space, "curl"), (Names{"_x", "_y", "_z"}));
  EXPECT_EQ(names(space, "hessian").size(), 9u);
  for (const char* scalar : {"laplacian", "divergence"})
    EXPECT_EQ(names(space, scalar), Names{""}) << scalar;
}

/// Derivatives in the file are believed, and further ones follow from them.
TEST(ExactField, UsesGivenDerivativesInPlaceOfItsOwn) {
  const std::string gradient = study_of(1, "x^2", "derivatives: {gradient: [\"x^3\"]}\n");
  EXPECT_TRUE(are(exact(gradient, 1, "gradient"), 1,
                  [](double x, double, double) { return Values{x * x * x}; }));
  EXPECT_TRUE(are(exact(gradient, 1, "laplacian"), 1,
                  [](double x, double, double) { return Values{3 * x * x}; }));
  const std::string all = study_of(
      2, "x",
      "derivatives: {hessian: [\"1\", \"2\", \"3\"], jacobian: [\"4\", \"5\", \"6\", \"7\"]}\n");
  EXPECT_TRUE(are(exact(all, 2, "gradient"), 2, [](double, double, double) {
    return Values{1, 0};
  }));
  EXPECT_TRUE(are(exact(all, 2, "hessian"), 2, [](double, double, double) {
    return Values{1, 2, 2, 3};
  }));
  EXPECT_TRUE(are(exact(all, 2, "laplacian"), 2, [](double, double, double) { return Values{4}; }));
  EXPECT_TRUE(
      are(exact(all, 2, "divergence"), 2, [](double, double, double) { return Values{11}; }));
  EXPECT_TRUE(are(exact(all, 2, "curl"), 2, [](double, double, double) { return Values{1}; }));
}

/// The key and the message of an error; empty without one.
template <class Work>
std::pair<std::string, std::string> refusal_of(Work work) {
  try {
    work();
  } catch (const InputError& error) {
    return {error.key(), error.what()};
  }
  return {};
}

TEST(ExactField, RefusesAPlaceWithoutValue) {
  const WrittenStudy written(study_of(2, "1/(x - y)",
                                      "density: \"1/x\"\nvector_field: [\"x\", \"y\"]\n"
                                      "derivatives: {jacobian: [\"1\", \"1/y\", \"0\", \"1\"]}\n"));
  const ExactField fields(written.study);
  const Values x{1, 2, 0.5, 0.5}, zero{0, 1}, flat{1, 0};
  const auto field = refusal_of([&] { fields.field(x); });
  EXPECT_EQ(field.first, "field");
  EXPECT_NE(field.second.find("(0.5, 0.5"), std::string::npos) << field.second;
  EXPECT_EQ(refusal_of([&] { fields.density(zero); }).first, "density");
  EXPECT_EQ(refusal_of([&] { fields.exact("curl", flat); }).first, "vector_field");
  EXPECT_EQ(refusal_of([&] { fields.field(Values{1, 2}); }).first, "");
}

}  // namespace
}  // namespace mote::test
