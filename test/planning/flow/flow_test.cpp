// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/flow/flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

const double kStadium = 0.2 * 0.2 + 0.01 * M_PI;  // mm², of a bead of 0.4 x 0.2 mm

Path beadLine(const std::vector<Point3>& points, const Bead& bead, double feed_mm_s) {
  Path path;
  path.role = PathRole::Infill;
  path.points = points;
  path.bead = bead;
  path.feed_mm_s = feed_mm_s;
  return path;
}

Toolpath of(std::vector<Path> paths) {
  Toolpath toolpath;
  toolpath.layers = {{0.2, 0.2, std::move(paths)}};
  return toolpath;
}

std::size_t limited(Toolpath& toolpath, double greatest, double slope = 0.0, double factor = 1.0) {
  FlowSettings settings;
  settings.greatest_mm3_s = greatest;
  settings.greatest_slope_mm3_s2 = slope;
  NoProgress nobody;
  const std::size_t slowed = limitFlow(toolpath, settings, factor, nobody);
  validate(toolpath);
  return slowed;
}

TEST(FlowLimit, LowersFeedsToTheVolumePerTime) {
  Toolpath thin = of({beadLine({{0, 0, 0.2}, {50, 0, 0.2}}, {0.4, 0.2}, 300.0)});
  EXPECT_EQ(limited(thin, 11.0), 1U);
  EXPECT_NEAR(thin.layers[0].paths[0].feed_mm_s.at(1), 154.0, 0.1);
  Toolpath thick = of({beadLine({{0, 0, 0.4}, {50, 0, 0.4}}, {0.8, 0.4}, 300.0)});
  EXPECT_EQ(limited(thick, 11.0), 1U);
  EXPECT_NEAR(thick.layers[0].paths[0].feed_mm_s.at(1), 38.5, 0.05);
}

TEST(FlowLimit, CountsTheFlowOfTheProgram) {
  Toolpath toolpath = of({beadLine({{0, 0, 0.2}, {50, 0, 0.2}}, {0.4, 0.2}, 300.0)});
  limited(toolpath, 11.0, 0.0, 1.1);
  EXPECT_NEAR(toolpath.layers[0].paths[0].feed_mm_s.at(1), 154.0 / 1.1, 0.1);
}

TEST(FlowLimit, LeavesSlowPathsTravelsAndAllWithoutALimit) {
  Path travel = beadLine({{50, 0, 0.2}, {0, 5, 0.2}}, {}, 400.0);
  travel.role = PathRole::Travel;
  Toolpath toolpath = of({beadLine({{0, 0, 0.2}, {50, 0, 0.2}}, {0.4, 0.2}, 100.0), travel});
  const std::string id = toolpathId(toolpath);
  EXPECT_EQ(limited(toolpath, 11.0), 0U);
  EXPECT_EQ(limited(toolpath, 0.0), 0U);
  EXPECT_EQ(limited(toolpath, 0.0, 100.0), 0U);
  EXPECT_EQ(toolpathId(toolpath), id);
}

/// The flow of each motion that deposits, and how long it takes.
struct Flow {
  double mm3_s;
  double duration_s;
};

std::vector<Flow> flowsOf(const Toolpath& toolpath) {
  std::vector<Flow> flows;
  for (const Path& path : toolpath.layers[0].paths)
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const double feed = path.feed_mm_s.at(end);
      flows.push_back(
          {feed * crossSection(path.bead.at(end)), (path.points[end] - path.points[m]).norm() / feed});
    }
  return flows;
}

TEST(FlowSlope, FollowsAStepEvenlyInTime) {
  // From 20 to 60 mm/s and back, where paths join: 2.857 mm³/s of change at 20 mm³/s² take 0.143 s.
  const double slope = 20.0;
  Toolpath toolpath = of({beadLine({{0, 0, 0.2}, {30, 0, 0.2}}, {0.4, 0.2}, 20.0),
                          beadLine({{30, 0, 0.2}, {90, 0, 0.2}}, {0.4, 0.2}, 60.0),
                          beadLine({{90, 0, 0.2}, {90, 30, 0.2}}, {0.4, 0.2}, 20.0)});
  const double before = depositedVolume(toolpath.layers[0].paths[1]);
  EXPECT_EQ(limited(toolpath, 0.0, slope), 1U) << "the slow ones stay";
  const std::vector<Flow> flows = flowsOf(toolpath);
  double ramp_s = 0.0;
  for (std::size_t i = 0; i + 1 < flows.size(); ++i) {
    const double between_s = 0.5 * (flows[i].duration_s + flows[i + 1].duration_s);
    EXPECT_LE(std::abs(flows[i + 1].mm3_s - flows[i].mm3_s), slope * between_s * 1.0001) << i;
    if (flows[i].mm3_s > 20.001 * kStadium && flows[i].mm3_s < 59.999 * kStadium)
      ramp_s += flows[i].duration_s;
  }
  EXPECT_NEAR(ramp_s, 2 * 40.0 * kStadium / slope, 1e-6);
  EXPECT_NEAR(depositedVolume(toolpath.layers[0].paths[1]), before, 1e-9);
  EXPECT_NEAR(std::max_element(flows.begin(), flows.end(),
                               [](const Flow& a, const Flow& b) { return a.mm3_s < b.mm3_s; })
                  ->mm3_s,
              60.0 * kStadium, 1e-9);
}

TEST(FlowSlope, DoesNotReachAFlowForWhichThereIsNoRoom) {
  Toolpath toolpath = of({beadLine({{0, 0, 0.2}, {30, 0, 0.2}}, {0.4, 0.2}, 20.0),
                          beadLine({{30, 0, 0.2}, {32, 0, 0.2}}, {0.4, 0.2}, 60.0),
                          beadLine({{32, 0, 0.2}, {32, 30, 0.2}}, {0.4, 0.2}, 20.0)});
  limited(toolpath, 0.0, 20.0);
  double greatest = 0.0;
  for (const Flow& flow : flowsOf(toolpath)) greatest = std::max(greatest, flow.mm3_s);
  // In the middle of 2 mm: q² = q0² + 2 s V / 2, less half a step.
  const double low = 20.0 * kStadium;
  const double peak = std::sqrt(low * low + 20.0 * 2.0 * kStadium);
  EXPECT_LT(greatest, peak);
  EXPECT_GT(greatest, 0.9 * peak);
}

TEST(FlowSlope, SmoothsAClosedPathOfSeveralFeeds) {
  Path loop = beadLine({{0, 0, 0.2}, {20, 0, 0.2}, {20, 20, 0.2}, {0, 20, 0.2}}, {0.4, 0.2}, 30.0);
  loop.is_closed = true;
  loop.feed_mm_s = AlongPath<double>(std::vector<double>{20.0, 20.0, 80.0, 20.0});
  PathEvent event;
  event.motion = 3;
  event.event.emplace<FanShare>(FanShare{0.5});
  loop.events = {event};
  Toolpath toolpath = of({loop});
  const double before = depositedVolume(loop);
  EXPECT_EQ(limited(toolpath, 0.0, 50.0), 1U);
  const Path& smooth = toolpath.layers[0].paths[0];
  EXPECT_TRUE(smooth.is_closed);
  EXPECT_GT(smooth.points.size(), 8U);
  EXPECT_NEAR(depositedVolume(smooth), before, 1e-9);
  EXPECT_EQ(smooth.points[smooth.events[0].motion], Point3(0, 20, 0.2)) << "events stay at their corner";
}

Coasting coasted(Toolpath& toolpath, double volume, double longest) {
  FlowSettings settings;
  settings.coast_mm3 = volume;
  settings.coast_longest_mm = longest;
  NoProgress nobody;
  const Coasting result = coast(toolpath, settings, nobody);
  validate(toolpath);
  return result;
}

TEST(Coast, LeavesTheLastVolumeOfEachRun) {
  PlanSettings settings;
  Toolpath toolpath = test::plan(
      test::layersOf(4, [](int) { return std::vector<Polygon>{rectangle(0, 0, 20, 20)}; }), settings);
  const ToolpathTotals before = totals(toolpath);
  std::size_t runs = 0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (std::size_t p = 0; p < layer.paths.size(); ++p)
      runs += layer.paths[p].role != PathRole::Travel &&
                      (p + 1 == layer.paths.size() || layer.paths[p + 1].role == PathRole::Travel)
                  ? 1
                  : 0;
  const Coasting coasting = coasted(toolpath, 0.2, 3.0);
  EXPECT_EQ(coasting.runs, runs);
  EXPECT_NEAR(coasting.left_mm3, 0.2 * static_cast<double>(runs), 1e-9);
  EXPECT_NEAR(totals(toolpath).deposited_mm3, before.deposited_mm3 - 0.2 * static_cast<double>(runs), 1e-6);
  const std::vector<Path>& paths = toolpath.layers[1].paths;
  for (std::size_t p = 0; p + 1 < paths.size(); ++p)
    if (paths[p].role != PathRole::Travel && paths[p + 1].role == PathRole::Travel) {
      EXPECT_NEAR(length(paths[p + 1]), 0.2 / kStadium, 1e-6) << "2.80 mm";
      EXPECT_FALSE(paths[p + 1].process.is_retracted);
      EXPECT_EQ(paths[p + 1].feed_mm_s.at(1), paths[p].feed_mm_s.at(1));
    }
}

TEST(Coast, IsBoundedByLengthAndHalfOfARun) {
  Toolpath longest = of({beadLine({{0, 0, 0.2}, {50, 0, 0.2}}, {0.4, 0.2}, 60.0)});
  coasted(longest, 0.2, 2.0);
  EXPECT_NEAR(length(longest.layers[0].paths.at(1)), 2.0, 1e-9);
  Toolpath half = of({beadLine({{0, 0, 0.2}, {3, 0, 0.2}}, {0.4, 0.2}, 60.0)});
  coasted(half, 0.2, 3.0);
  EXPECT_NEAR(length(half.layers[0].paths.at(1)), 1.5, 1e-9);
}

TEST(Coast, OpensALoopBeforeItsEnd) {
  Path loop = beadLine({{0, 0, 0.2}, {20, 0, 0.2}, {20, 20, 0.2}, {0, 20, 0.2}}, {0.4, 0.2}, 30.0);
  loop.is_closed = true;
  Toolpath toolpath = of({loop});
  coasted(toolpath, 0.1, 3.0);
  const std::vector<Path>& paths = toolpath.layers[0].paths;
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_FALSE(paths[0].is_closed);
  EXPECT_TRUE(paths[0].lastPoint().isApprox(Point3(0, 0.1 / kStadium, 0.2), 1e-9));
  EXPECT_EQ(paths[1].lastPoint(), Point3(0, 0, 0.2));
}

TEST(Coast, ChangesNothingWithoutAVolume) {
  Toolpath toolpath = of({beadLine({{0, 0, 0.2}, {50, 0, 0.2}}, {0.4, 0.2}, 60.0)});
  const std::string id = toolpathId(toolpath);
  EXPECT_EQ(coasted(toolpath, 0.0, 2.0).runs, 0U);
  EXPECT_EQ(toolpathId(toolpath), id);
}

std::string firstCode(AdvanceWord word) {
  FlowSettings settings;
  settings.advance_s = 0.05;
  settings.advance_word = word;
  Toolpath toolpath = of({beadLine({{0, 0, 0.2}, {50, 0, 0.2}}, {0.4, 0.2}, 60.0)});
  addAdvance(toolpath, settings);
  return std::get<MachineCode>(toolpath.layers[0].paths[0].events.at(0).event).text;
}

TEST(PressureAdvance, IsStatedInTheWordsOfTheFirmware) {
  EXPECT_EQ(firstCode(AdvanceWord::Marlin), "M900 K0.05");
  EXPECT_EQ(firstCode(AdvanceWord::Klipper), "SET_PRESSURE_ADVANCE ADVANCE=0.05");
  EXPECT_EQ(firstCode(AdvanceWord::RepRapFirmware), "M572 D0 S0.05");
}

TEST(PressureAdvance, IsStatedWhereItChangesWithTheRole) {
  FlowSettings settings;
  settings.advance_s = 0.05;
  settings.advance_by_role = "outer_wall=0.04, infill = 0.06";
  std::vector<Path> paths;
  for (const PathRole role : {PathRole::Skirt, PathRole::InnerWall, PathRole::OuterWall, PathRole::Infill,
                              PathRole::Infill, PathRole::GapFill}) {
    paths.push_back(beadLine({{0, 0, 0.2}, {50, 0, 0.2}}, {0.4, 0.2}, 60.0));
    paths.back().role = role;
  }
  Toolpath toolpath = of(paths);
  addAdvance(toolpath, settings);
  std::string stated;
  for (const Path& path : toolpath.layers[0].paths)
    stated += path.events.empty() ? "-;" : std::get<MachineCode>(path.events[0].event).text + ";";
  EXPECT_EQ(stated, "M900 K0.05;-;M900 K0.04;M900 K0.06;-;M900 K0.05;");
}

/// Firmwares keep an advance for each tool: one that was never told has none.
TEST(PressureAdvance, IsStatedForEachToolThatIsTaken) {
  const auto statedIn = [](AdvanceWord word) {
    FlowSettings settings;
    settings.advance_s = 0.05;
    settings.advance_word = word;
    std::vector<Path> paths;
    for (const std::uint32_t tool : {0U, 1U, 1U, 0U}) {
      paths.push_back(beadLine({{0, 0, 0.2}, {50, 0, 0.2}}, {0.4, 0.2}, 60.0));
      paths.back().tool = tool;
    }
    Toolpath toolpath = of(paths);
    addAdvance(toolpath, settings);
    std::string stated;
    for (const Path& path : toolpath.layers[0].paths)
      stated += path.events.empty() ? "-;" : std::get<MachineCode>(path.events[0].event).text + ";";
    return stated;
  };
  EXPECT_EQ(statedIn(AdvanceWord::Marlin), "M900 K0.05;M900 K0.05;-;M900 K0.05;");
  EXPECT_EQ(statedIn(AdvanceWord::RepRapFirmware), "M572 D0 S0.05;M572 D1 S0.05;-;M572 D0 S0.05;");
}

TEST(PressureAdvance, RefusesWhatIsNoAdvanceOfARole) {
  for (const char* const text :
       {"outer_wall", "roof=0.1", "infill=", "infill=-1", "infill=0.1 s", "infill=11"}) {
    FlowSettings settings;
    settings.advance_by_role = text;
    EXPECT_THROW(requireConsistent(settings), InvalidConfig) << text;
  }
}

TEST(PressureAdvance, IsNotStatedTogetherWithFeedForward) {
  FlowSettings settings;
  settings.advance_s = 0.05;
  EXPECT_NO_THROW(requireConsistent(settings));
  settings.lag_s = 0.1;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  settings.advance_s = 0.0;
  EXPECT_NO_THROW(requireConsistent(settings));
}

}  // namespace
}  // namespace lamina
