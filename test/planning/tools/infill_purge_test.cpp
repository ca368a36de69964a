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

TEST(InfillPurge, LeavesWhatPurgesTheToolBefore) {
  ToolRuns runs = twoRuns();
  runs.push_back(runs[1]);
  runs[2].tool = 2;
  for (Path& path : runs[2].paths) path.tool = 2;
  runs = withInfillFirst(std::move(runs), 1, 4 * kLine);
  ASSERT_NEAR(leadingInfill(runs[1]), 4 * kLine, 1e-12);
  runs = withInfillFirst(std::move(runs), 2, 4 * kLine);
  EXPECT_NEAR(leadingInfill(runs[1]), 4 * kLine, 1e-12);
  EXPECT_NEAR(leadingInfill(runs[2]), 2 * kLine, 1e-12) << "its own alone";
  EXPECT_EQ(placesOf(runs[1]), (std::vector<double>{13, 15, 3, 5, 11, 17}));
}

TEST(InfillPurge, TakesWhatARunLaysBehindItsPurge) {
  ToolRuns runs = twoRuns();
  runs.push_back({2, {lineAt(21, PathRole::OuterWall, 2)}, {}});
  runs = withInfillFirst(std::move(runs), 1, 0.5 * kLine);
  runs = withInfillFirst(std::move(runs), 2, 1.5 * kLine);
  EXPECT_NEAR(leadingInfill(runs[1]), kLine, 1e-12);
  EXPECT_EQ(placesOf(runs[1]), (std::vector<double>{13, 11, 17}));
  EXPECT_NEAR(leadingInfill(runs[2]), 2 * kLine, 1e-12);
}

TEST(InfillPurge, LeavesNoPartOfAWayThatWasAWipeAndATravel) {
  ToolRuns runs = twoRuns();
  runs[0].paths = {lineAt(1, PathRole::OuterWall, 0), lineAt(2, PathRole::Travel, 0),
                   lineAt(3, PathRole::Travel, 0),    lineAt(4, PathRole::Infill, 0),
                   lineAt(5, PathRole::Travel, 0),    lineAt(6, PathRole::Travel, 0),
                   lineAt(7, PathRole::OuterWall, 0), lineAt(8, PathRole::Travel, 0),
                   lineAt(9, PathRole::Travel, 0),    lineAt(10, PathRole::Infill, 0)};
  runs = withInfillFirst(std::move(runs), 1, 100.0 * kLine);
  EXPECT_EQ(placesOf(runs[0]), (std::vector<double>{1, 7}));
}

TEST(InfillPurge, OfNothingChangesNothing) {
  const ToolRuns runs = withInfillFirst(twoRuns(), 1, 0.0);
  EXPECT_EQ(placesOf(runs[0]).size() + placesOf(runs[1]).size(), 14U);
  EXPECT_EQ(leadingInfill(runs[1]), 0.0);
}

}  // namespace
}  // namespace lamina
