#include "mote/xivas/box_points.hpp"

#include <gtest/gtest.h>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

TEST(BoxPoints, AreAsManyAsTheyAreCounted) {
  const Vec<2> lower(-1, 0), upper(1, 0.7);
  for (const double spacing : {0.09, 0.3, 5.0})
    EXPECT_EQ(static_cast<double>(points_in_box<2>(lower, upper, {.spacing = spacing}).size()),
              2 * count_of_points_in_box<2>(lower, upper, spacing));
  EXPECT_EQ(count_of_points_in_box<3>(Vec<3>::Zero(), Vec<3>(1, 2, 3), 1), 2 * 3 * 4);
}

TEST(BoxPoints, BeyondWhatCanBeCountedAreRefused) {
  const Vec<3> lower = Vec<3>::Zero(), upper = Vec<3>::Ones();
  for (const double spacing : {1e-3, 1e-4, 1e-10, 1e-300})
    EXPECT_THROW(points_in_box<3>(lower, upper, {.spacing = spacing}), InputError);
  EXPECT_TRUE(is_countable_mesh<3>(count_of_points_in_box<3>(lower, upper, 1e-2)));
}

}  // namespace
}  // namespace mote
