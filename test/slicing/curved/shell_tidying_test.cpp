// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/shell_tidying.hpp"

#include <gtest/gtest.h>

#include "support/curved_parts.hpp"

namespace lamina {
namespace {

// Those of curved layers 0.2 mm high.
constexpr TidyLimits kLimits{0.004, 0.16};

/// A level sheet of cells of 0.2 mm, without some of its triangles.
LayerSurface sheetWithout(std::size_t first, std::size_t count) {
  LayerSurface sheet;
  sheet.middle = test::gridSurface(10, [](double u, double v) { return Point3(2.0 * u, 2.0 * v, 1.0); });
  for (const Point3& vertex : sheet.middle.vertices) {
    sheet.tip.emplace_back(vertex + 0.1 * Point3::UnitZ());
    sheet.normal.emplace_back(Point3::UnitZ());
    sheet.height_mm.push_back(0.2);
  }
  const auto from = sheet.middle.triangles.begin() + static_cast<std::ptrdiff_t>(first);
  sheet.middle.triangles.erase(from, from + static_cast<std::ptrdiff_t>(count));
  return sheet;
}

TEST(ShellTidying, AHoleSmallerThanABeadIsClosed) {
  const LayerSurface tidy = tidied(sheetWithout(110, 4), kLimits);
  EXPECT_NEAR(surfaceArea(tidy.middle), 4.0, 1e-9);
  for (const Triangle& corner : tidy.middle.triangles)
    for (const std::uint32_t vertex : corner) {
      EXPECT_NEAR(tidy.tip[vertex].z(), 1.1, 1e-9);
      EXPECT_NEAR(tidy.height_mm[vertex], 0.2, 1e-9);
    }
}

TEST(ShellTidying, ALargerHoleStays) {
  EXPECT_NEAR(surfaceArea(tidied(sheetWithout(104, 10), kLimits).middle), 3.8, 1e-9);
}

TEST(ShellTidying, TheOutlineIsNoHole) {
  LayerSurface small = sheetWithout(2, 198);
  EXPECT_NEAR(surfaceArea(tidied(small, kLimits).middle), 0.04, 1e-9);
}

TEST(ShellTidying, APieceTooSmallToLayIsDropped) {
  LayerSurface small = sheetWithout(1, 199);
  for (Point3& vertex : small.middle.vertices) vertex *= 0.1;
  EXPECT_TRUE(tidied(small, kLimits).middle.triangles.empty());
}

}  // namespace
}  // namespace lamina
