// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/infill_purge.hpp"

#include <gtest/gtest.h>

#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// 10 mm of a bead, at that place along y.
Path lineAt(double y, PathRole role, std::uint32_t tool) {
  Path path = test::straightPath({0, y, 0.2}, {10, y, 0.2});
  path.role = role;
  path.tool = tool;
  path.bead = role == PathRole::Travel ? Bead{} : Bead{0.4, 0.2};
  return path;
}

std::vector<double> placesOf(const ToolRun& run) {
  std::vector<double> places;
  for (const Path& path : run.paths) {
    EXPECT_TRUE(path.role == PathRole::Travel || path.tool == run.tool);
    places.push_back(path.firstPoint().y());
  }
  return places;
}

const double kLine = depositedVolume(lineAt(0, PathRole::Infill, 0));

/// Walls and infill of tool 0, then of tool 1; with travels in between.
ToolRuns twoRuns() {
  ToolRuns runs(2);
  for (std::uint32_t tool = 0; tool < 2; ++tool) {
    const double y = 10.0 * tool;
    runs[tool].tool = tool;
    runs[tool].paths = {lineAt(y + 1, PathRole::OuterWall, tool), lineAt(y + 2, PathRole::Travel, tool),
                        lineAt(y + 3, PathRole::Infill, tool),    lineAt(y + 4, PathRole::Travel, tool),
                        lineAt(y + 5, PathRole::Infill, tool),    lineAt(y + 6, PathRole::Travel, tool),
                        lineAt(y + 7, PathRole::TopSkin, tool)};
  }
  return runs;
}

TEST(InfillPurge, TakesItsOwnInfillFirst) {
  const ToolRuns runs = withInfillFirst(twoRuns(), 1, 0.5 * kLine);
  EXPECT_EQ(placesOf(runs[1]), (std::vector<double>{13, 11, 15, 16, 17}));
  EXPECT_EQ(placesOf(runs[0]), (std::vector<double>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_NEAR(leadingInfill(runs[1]), kLine, 1e-12);
}

TEST(InfillPurge, TakesThatOfToolsBeforeAsWholePaths) {
  const ToolRuns runs = withInfillFirst(twoRuns(), 1, 2.5 * kLine);
  EXPECT_EQ(placesOf(runs[1]), (std::vector<double>{13, 15, 3, 11, 17}));
  EXPECT_EQ(placesOf(runs[0]), (std::vector<double>{1, 5, 6, 7}));
  EXPECT_NEAR(leadingInfill(runs[1]), 3 * kLine, 1e-12);
}

TEST(InfillPurge, LeavesRunsOfNothingButInfill) {
  ToolRuns runs = twoRuns();
  runs[0].paths = {lineAt(3, PathRole::Infill, 0), lineAt(4, PathRole::Travel, 0),
                   lineAt(5, PathRole::Infill, 0)};
  runs = withInfillFirst(std::move(runs), 1, 100.0 * kLine);
  EXPECT_EQ(placesOf(runs[0]), (std::vector<double>{3, 4, 5}));
  EXPECT_NEAR(leadingInfill(runs[1]), 2 * kLine, 1e-12);
}

TEST(InfillPurge, OfNothingChangesNothing) {
  const ToolRuns runs = withInfillFirst(twoRuns(), 1, 0.0);
  EXPECT_EQ(placesOf(runs[0]).size() + placesOf(runs[1]).size(), 14U);
  EXPECT_EQ(leadingInfill(runs[1]), 0.0);
}

}  // namespace
}  // namespace lamina
