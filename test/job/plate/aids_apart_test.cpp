// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/aids_apart.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// A bead of 0.4 x 0.2 mm fills 0.357080 mm of width.
constexpr double kPlanWidth = 0.35708;

/// One bead along x from x = 0 to 10, in a layer of its own.
Toolpath lineOf(PathRole role, double y, double top_mm) {
  Path path;
  path.role = role;
  path.points = {{0.0, y, top_mm}, {10.0, y, top_mm}};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 10.0;
  ToolpathLayer layer;
  layer.z_mm = top_mm;
  layer.height_mm = 0.2;
  layer.paths = {path};
  Toolpath toolpath;
  toolpath.layers = {layer};
  return toolpath;
}

std::string whyApart(const Toolpath& a, const Toolpath& b, const Point3& at_b = Point3::Zero()) {
  try {
    requireAidsApart({{"left", &a, {5, 0, 0}}, {"right", &b, Point3(5, 0, 0) + at_b}});
    return "";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

TEST(AidsApart, NameWhatMeetsAndWhere) {
  const Toolpath support = lineOf(PathRole::Support, 3.0, 4.2);
  EXPECT_EQ(
      whyApart(support, lineOf(PathRole::OuterWall, 3.2, 4.3)),
      "parts 'left' and 'right' overlap: support of 'left' meets outer_wall of 'right' at z 4.2 mm, about "
      "(10.00, 3.00) mm of the bed; expected parts that are farther apart (at_mm, plate.spacing_mm)");
  EXPECT_NE(whyApart(lineOf(PathRole::Infill, 3.2, 4.3), support), "") << "whichever comes first";
  EXPECT_NE(whyApart(support, lineOf(PathRole::Brim, 0.0, 4.2), {0, 3.1, 0}), "") << "where they stand";
}

TEST(AidsApart, AllowBeadsSideBySide) {
  const Toolpath support = lineOf(PathRole::Support, 3.0, 4.2);
  EXPECT_EQ(whyApart(support, lineOf(PathRole::Support, 3.0 + kPlanWidth, 4.2)), "");
  EXPECT_NE(whyApart(support, lineOf(PathRole::Support, 2.98 + kPlanWidth, 4.2)), "");
}

TEST(AidsApart, AllowBeadsAboveEachOther) {
  const Toolpath support = lineOf(PathRole::Support, 3.0, 4.2);
  EXPECT_EQ(whyApart(support, lineOf(PathRole::Support, 3.0, 4.4)), "");
  EXPECT_NE(whyApart(support, lineOf(PathRole::Support, 3.0, 4.39)), "");
}

TEST(AidsApart, FindBeadsThatCross) {
  const Toolpath support = lineOf(PathRole::Support, 3.0, 4.2);
  Toolpath across = lineOf(PathRole::InnerWall, 0.0, 4.2);
  across.layers[0].paths[0].points = {{5, 0, 4.2}, {5, 6, 4.2}};
  EXPECT_NE(whyApart(support, across), "");
  across.layers[0].paths[0].points = {{5, 3.2 + kPlanWidth, 4.2}, {5, 6, 4.2}};
  EXPECT_EQ(whyApart(support, across), "");
}

/// Parts by themselves are compared by their sections, and may touch.
TEST(AidsApart, LeavePartsToThemselves) {
  EXPECT_EQ(whyApart(lineOf(PathRole::OuterWall, 3.0, 4.2), lineOf(PathRole::InnerWall, 3.0, 4.2)), "");
  EXPECT_EQ(whyApart(lineOf(PathRole::Travel, 3.0, 4.2), lineOf(PathRole::Support, 3.0, 4.2)), "");
}

}  // namespace
}  // namespace lamina
