// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/planning/runs/runs.hpp"

namespace lamina {
namespace {

constexpr double kTurn = 2.0 * M_PI;
constexpr double kGolden = 0.6180339887498949;

Path depositedBead(std::vector<Point3> points, const Bead& section = {1.0, 0.5}) {
  Path path;
  path.role = PathRole::OuterWall;
  path.points = std::move(points);
  path.bead = section;
  path.feed_mm_s = 8.0;
  return path;
}

Path travelTo(const Point3& from, const Point3& to) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {from, from + Point3(0, 0, 5), to + Point3(0, 0, 5), to};
  path.feed_mm_s = 100.0;
  return path;
}

/// Against the clock from +x on.
Path ring(double radius_mm, double z_mm, std::size_t count = 360) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = kTurn * static_cast<double>(i) / static_cast<double>(count);
    points.emplace_back(radius_mm * std::cos(angle), radius_mm * std::sin(angle), z_mm);
  }
  Path path = depositedBead(std::move(points));
  path.is_closed = true;
  return path;
}

/// Layers of rings, with travels between them.
Toolpath tube(double radius_mm, std::size_t layers) {
  Toolpath toolpath;
  Point3 from(0, 0, 50);
  for (std::size_t l = 0; l < layers; ++l) {
    const double z_mm = 0.5 * static_cast<double>(l + 1);
    Path wall = ring(radius_mm, z_mm);
    ToolpathLayer layer{z_mm, 0.5, {travelTo(from, wall.firstPoint()), wall}};
    from = wall.firstPoint();
    toolpath.layers.push_back(std::move(layer));
  }
  return toolpath;
}

Toolpath ofPaths(std::vector<Path> paths) {
  Toolpath toolpath;
  toolpath.layers = {{0.5, 0.5, std::move(paths)}};
  validate(toolpath);
  return toolpath;
}

LeadSettings straightLead(double length_mm, double angle_deg = 0.0) {
  LeadSettings lead;
  lead.in = lead.out = LeadShape::Line;
  lead.length_mm = length_mm;
  lead.angle_deg = angle_deg;
  return lead;
}

LeadCount addLeads(Toolpath& toolpath, const LeadSettings& settings) {
  return addEnds(toolpath, settings, {}).leads;
}

std::size_t addEntries(Toolpath& toolpath, const EntrySettings& settings) {
  return addEnds(toolpath, {}, settings).entries;
}

/// Shares of the turn at which the rings of a tube start.
std::vector<double> startsOfTube(const Toolpath& toolpath) {
  std::vector<double> starts;
  for (const ToolpathLayer& layer : toolpath.layers) {
    const Point3& start = layer.paths[1].firstPoint();
    const double share = std::atan2(start.y(), start.x()) / kTurn;
    starts.push_back(share < -1e-9 ? share + 1.0 : share);
  }
  return starts;
}

double apart(double a, double b) {
  const double way = std::abs(a - b);
  return std::min(way, 1.0 - way);
}

TEST(SpreadStarts, GoldenStartsStandApartForThreeLayers) {
  Toolpath toolpath = tube(20.0, 30);
  StartSettings settings;
  settings.rule = StartRule::Golden;
  EXPECT_EQ(spreadStarts(toolpath, settings), 30U);
  validate(toolpath);
  const std::vector<double> starts = startsOfTube(toolpath);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EXPECT_NEAR(apart(starts[i], std::fmod(kGolden * static_cast<double>(i), 1.0)), 0.0, 1e-4);
    if (i >= 1) {
      EXPECT_NEAR(apart(starts[i], starts[i - 1]), 0.381966, 1e-4);
    }
    if (i >= 2) {
      EXPECT_NEAR(apart(starts[i], starts[i - 2]), 0.236068, 1e-4);
    }
    if (i >= 3) {
      EXPECT_NEAR(apart(starts[i], starts[i - 3]), 0.145898, 1e-4);
    }
  }
  EXPECT_NEAR(depositedVolume(toolpath.layers[7].paths[1]), depositedVolume(ring(20.0, 4.0)), 1e-9);
}

TEST(SpreadStarts, OppositeStartsStandHalfARoundApart) {
  Toolpath toolpath = tube(20.0, 4);
  StartSettings settings;
  settings.rule = StartRule::Opposite;
  settings.first_share = 0.25;
  spreadStarts(toolpath, settings);
  const std::vector<double> starts = startsOfTube(toolpath);
  EXPECT_NEAR(starts[0], 0.25, 1e-4);
  EXPECT_NEAR(starts[1], 0.75, 1e-4);
  EXPECT_NEAR(starts[2], 0.25, 1e-4);
}

TEST(SpreadStarts, LeavesRunsOfSeveralPathsAndOpenOnes) {
  Path wall = ring(10.0, 0.5);
  Toolpath joined = ofPaths({wall, depositedBead({wall.firstPoint(), {20, 0, 0.5}})});
  const std::string id = toolpathId(joined);
  StartSettings settings;
  settings.rule = StartRule::Opposite;
  settings.first_share = 0.3;
  EXPECT_EQ(spreadStarts(joined, settings), 0U);
  EXPECT_EQ(toolpathId(joined), id);
}

/// The nozzle leans outside by 30 deg all round, and travels rise along it.
Toolpath leaningTube() {
  Path wall = ring(20.0, 10.0);
  std::vector<Eigen::Quaterniond> each;
  for (std::size_t i = 0; i < wall.points.size(); ++i) {
    const double angle = kTurn * static_cast<double>(i) / static_cast<double>(wall.points.size());
    each.push_back(Eigen::AngleAxisd(angle, Point3::UnitZ()) *
                   Eigen::AngleAxisd(M_PI / 6.0, Point3::UnitY()) * nozzleDown());
  }
  const Eigen::Quaterniond nozzle = each.front();
  wall.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
  const Point3 start = wall.firstPoint();
  const Point3 off = start - 2.0 * (nozzle * Point3::UnitZ());
  Path to = travelTo(start, start);
  to.points = {{0, 0, 40}, {off.x(), off.y(), 40}, off, start};
  to.orientation =
      AlongPath<Eigen::Quaterniond>(std::vector<Eigen::Quaterniond>{nozzleDown(), nozzle, nozzle, nozzle});
  Path away = to;
  std::reverse(away.points.begin(), away.points.end());
  away.orientation =
      AlongPath<Eigen::Quaterniond>(std::vector<Eigen::Quaterniond>{nozzle, nozzle, nozzle, nozzleDown()});
  return ofPaths({to, wall, away});
}

TEST(SpreadStarts, TravelsComeAsTheNozzleLeansAtTheNewStart) {
  Toolpath toolpath = leaningTube();
  StartSettings settings;
  settings.rule = StartRule::Opposite;
  settings.first_share = 0.5;
  EXPECT_EQ(spreadStarts(toolpath, settings), 1U);
  validate(toolpath);
  const auto& paths = toolpath.layers[0].paths;
  const Eigen::Quaterniond& nozzle = paths[1].orientation.at(0);
  // 2 mm back along an axis that leans by 30 deg to the other side now.
  const Point3 raised(-21.0, 0.0, 10.0 + std::sqrt(3.0));
  EXPECT_LT((paths[0].points[3] - Point3(-20, 0, 10)).norm(), 1e-6);
  EXPECT_LT((paths[0].points[2] - raised).norm(), 1e-6);
  EXPECT_LT((paths[0].points[1] - Point3(-21, 0, 40)).norm(), 1e-6);
  EXPECT_LT((paths[2].points[1] - raised).norm(), 1e-6);
  for (const std::size_t waypoint : {1U, 2U, 3U})
    EXPECT_LT(paths[0].orientation.at(waypoint).angularDistance(nozzle), 1e-9);
  EXPECT_LT(paths[0].orientation.at(0).angularDistance(nozzleDown()), 1e-9);
  for (const std::size_t waypoint : {0U, 1U, 2U})
    EXPECT_LT(paths[2].orientation.at(waypoint).angularDistance(nozzle), 1e-9);
}

TEST(OverlapEnds, TravelsLeaveAsTheNozzleLeansAtTheNewEnd) {
  Toolpath toolpath = leaningTube();
  LeadSettings settings;
  settings.overlap_mm = 0.25 * length(toolpath.layers[0].paths[1]);
  EXPECT_EQ(overlapEnds(toolpath, settings), 1U);
  validate(toolpath);
  const auto& paths = toolpath.layers[0].paths;
  const Eigen::Quaterniond& nozzle = paths[1].orientation.at(paths[1].points.size() - 1);
  EXPECT_LT((paths[2].points[0] - Point3(0, 20, 10)).norm(), 1e-6);
  EXPECT_LT((paths[2].points[1] - Point3(0, 21, 10.0 + std::sqrt(3.0))).norm(), 1e-6);
  EXPECT_LT(paths[2].orientation.at(0).angularDistance(nozzle), 1e-9);
  EXPECT_LT(paths[2].orientation.at(1).angularDistance(nozzle), 1e-9);
}

TEST(OverlapEnds, GrowsAndFadesToTheBeadEverywhere) {
  Toolpath toolpath = tube(20.0, 1);
  const double whole_mm = length(toolpath.layers[0].paths[1]);
  LeadSettings settings;
  settings.overlap_mm = 10.0;
  EXPECT_EQ(overlapEnds(toolpath, settings), 1U);
  validate(toolpath);
  const Path& path = toolpath.layers[0].paths[1];
  EXPECT_FALSE(path.is_closed);
  EXPECT_NEAR(length(path), whole_mm + 10.0, 1e-6);
  const double section = crossSection({1.0, 0.5});
  EXPECT_NEAR(depositedVolume(path), section * whole_mm, 1e-6);
  // The first and the last motions go the same ways; their sections add up.
  double way_mm = 0.0;
  for (std::size_t i = 1; way_mm < 9.9; ++i) {
    const double length_mm = (path.points[i] - path.points[i - 1]).norm();
    way_mm += length_mm;
    std::size_t again = path.points.size() - 1;
    while ((path.points[again] - path.points[i]).norm() > 1e-9) --again;
    EXPECT_GT(again, 300U);
    EXPECT_NEAR(crossSection(path.bead.at(i)) + crossSection(path.bead.at(again)), section, 1e-9);
    EXPECT_NEAR(crossSection(path.bead.at(i)), section * (way_mm - 0.5 * length_mm) / 10.0, 1e-9);
  }
}

TEST(OverlapEnds, LeavesAGapIfNegative) {
  Toolpath toolpath = tube(20.0, 1);
  const Path whole = toolpath.layers[0].paths[1];
  LeadSettings settings;
  settings.overlap_mm = -0.06;
  EXPECT_EQ(overlapEnds(toolpath, settings), 1U);
  validate(toolpath);
  const Path& path = toolpath.layers[0].paths[1];
  EXPECT_EQ(path.firstPoint(), whole.firstPoint());
  EXPECT_NEAR((path.lastPoint() - whole.firstPoint()).norm(), 0.06, 1e-9) << "open";
  EXPECT_NEAR(depositedVolume(path), crossSection({1.0, 0.5}) * (length(whole) - 0.06), 1e-9);
}

TEST(OverlapEnds, LeavesAGapOverSeveralMotions) {
  Toolpath toolpath = tube(20.0, 1);
  const Path whole = toolpath.layers[0].paths[1];
  LeadSettings settings;
  settings.overlap_mm = -2.5 * length(whole) / static_cast<double>(whole.points.size());
  EXPECT_EQ(overlapEnds(toolpath, settings), 1U);
  validate(toolpath);
  const Path& path = toolpath.layers[0].paths[1];
  EXPECT_EQ(path.points.size(), whole.points.size() - 1)
      << "all corners but two, and a last point amid a motion";
  EXPECT_NEAR(length(path), length(whole) + settings.overlap_mm, 1e-9);
}

TEST(OverlapEnds, LeavesRunsClosedThatTheGapWouldOpenWide) {
  Toolpath toolpath = tube(1.0, 1);  // the ring is 6.28 mm long
  LeadSettings settings;
  settings.overlap_mm = -0.63;
  EXPECT_EQ(overlapEnds(toolpath, settings), 0U);
}

TEST(OverlapEnds, RefusesOneAsLongAsTheRun) {
  Toolpath toolpath = tube(1.0, 1);
  LeadSettings settings;
  settings.overlap_mm = 6.5;  // mm: the ring is 6.28 mm long
  try {
    overlapEnds(toolpath, settings);
    FAIL();
  } catch (const InvalidInput& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("layer 0 at 0.5 mm, path 1"), std::string::npos) << what;
    EXPECT_NE(what.find("lead.overlap_mm is 6.5"), std::string::npos) << what;
    EXPECT_NE(what.find("6.28"), std::string::npos) << what;
  }
}

TEST(Leads, AreNoLongerThanTheRunThatTheyLeadTo) {
  Toolpath toolpath = ofPaths({depositedBead({{0, 0, 0.5}, {20, 0, 0.5}})});
  const LeadCount count = addLeads(toolpath, straightLead(90.0));
  EXPECT_EQ(count.added, 2U);
  EXPECT_EQ(count.shortened, 2U);
  const std::vector<Path>& paths = toolpath.layers[0].paths;
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_NEAR(length(paths[0]), 20.0, 1e-9);
  EXPECT_NEAR(length(paths[2]), 20.0, 1e-9);
}

TEST(Leads, LinesGoOnAlongTheTangent) {
  const Point3 start(0, 0, 0.5);
  const Point3 end(30, 0, 0.5);
  Toolpath toolpath =
      ofPaths({travelTo({0, 20, 0.5}, start), depositedBead({start, end}), travelTo(end, {9, 9, 0.5})});
  const LeadCount count = addLeads(toolpath, straightLead(6.0));
  validate(toolpath);
  EXPECT_EQ(count.added, 2U);
  EXPECT_EQ(count.shortened + count.left_out, 0U);
  const auto& paths = toolpath.layers[0].paths;
  ASSERT_EQ(paths.size(), 5U);
  EXPECT_EQ(paths[1].role, PathRole::Travel);
  EXPECT_LT((paths[1].points[0] - Point3(-6, 0, 0.5)).norm(), 1e-9);
  EXPECT_LT((paths[3].points[1] - Point3(36, 0, 0.5)).norm(), 1e-9);
  EXPECT_EQ(paths[1].feed_mm_s.at(1), 8.0);
  // The travels come from above to where the leads begin and end.
  EXPECT_LT((paths[0].points[2] - Point3(-6, 0, 5.5)).norm(), 1e-9);
  EXPECT_LT((paths[4].points[1] - Point3(36, 0, 5.5)).norm(), 1e-9);
}

TEST(Leads, RiseAndTurnByTheirAngles) {
  Toolpath toolpath = ofPaths({depositedBead({{0, 0, 0.5}, {30, 0, 0.5}})});
  LeadSettings settings = straightLead(10.0, 30.0);
  settings.rise_deg = 20.0;
  addLeads(toolpath, settings);
  const Point3 offset = toolpath.layers[0].paths[0].points[0] - Point3(0, 0, 0.5);
  EXPECT_NEAR(offset.norm(), 10.0, 1e-9);
  EXPECT_NEAR(offset.z(), 10.0 * std::sin(20.0 * M_PI / 180.0), 1e-9);
  EXPECT_NEAR(-offset.x(), 10.0 * std::cos(20.0 * M_PI / 180.0) * std::cos(M_PI / 6.0), 1e-9);
}

TEST(Leads, ArcsAreTangentAndOnTheFreeSideOfATube) {
  Path outer = ring(20.0, 0.5);
  Path hole = ring(15.0, 0.5);
  std::reverse(hole.points.begin() + 1, hole.points.end());
  Toolpath toolpath = ofPaths({travelTo({0, 0, 9}, outer.firstPoint()), outer,
                               travelTo(outer.firstPoint(), hole.firstPoint()), hole});
  LeadSettings settings;
  settings.in = settings.out = LeadShape::Arc;
  settings.radius_mm = 4.0;
  settings.sweep_deg = 90.0;
  EXPECT_EQ(addLeads(toolpath, settings).added, 4U);
  validate(toolpath);
  const auto& paths = toolpath.layers[0].paths;
  ASSERT_EQ(paths.size(), 8U);
  for (const std::size_t index : {std::size_t{1}, std::size_t{3}})
    for (const Point3& point : paths[index].points) EXPECT_GE(point.head<2>().norm(), 20.0 - 1e-6);
  for (const std::size_t index : {std::size_t{5}, std::size_t{7}})
    for (const Point3& point : paths[index].points) EXPECT_LE(point.head<2>().norm(), 15.0 + 1e-6);
  ASSERT_EQ(paths[1].points.size(), 19U);  // every 5 deg
  // A quarter of a circle of 4 mm: 4 mm on and 4 mm aside. The ring's first side is half a degree askew.
  const Point3 start = paths[1].points[0] - outer.firstPoint();
  EXPECT_NEAR(start.x(), 4.0, 0.1);
  EXPECT_NEAR(start.y(), -4.0, 0.1);
  const Point3 tangent = (paths[1].points[18] - paths[1].points[17]).normalized();
  EXPECT_NEAR(tangent.dot((outer.points[1] - outer.points[0]).normalized()), std::cos(2.5 * M_PI / 180),
              1e-6);
}

TEST(Leads, AreShortenedToTheRoomOrLeftOut) {
  // A wall stands 5 mm behind the start, and one right at the end.
  const Path run = depositedBead({{0, 0, 0.5}, {30, 0, 0.5}});
  const Path behind = depositedBead({{-5, -10, 0.5}, {-5, 10, 0.5}});
  const Path at_end = depositedBead({{31.2, -10, 0.5}, {31.2, 10, 0.5}});
  Toolpath toolpath = ofPaths(
      {behind, travelTo({-5, 10, 0.5}, {0, 0, 0.5}), run, travelTo({30, 0, 0.5}, {31.2, -10, 0.5}), at_end});
  LeadSettings settings = straightLead(10.0);
  settings.least_mm = 1.0;
  const LeadCount count = addLeads(toolpath, settings);
  validate(toolpath);
  EXPECT_EQ(count.left_out, 1U);
  EXPECT_EQ(count.shortened, 1U);
  EXPECT_EQ(count.added, 5U);
  // Beads of 1 x 0.5 mm are packed 0.893 mm apart.
  const double pitch_mm = 0.5 + M_PI / 8.0;
  const Path& lead = toolpath.layers[0].paths[4];
  EXPECT_LE(lead.points[0].norm(), 5.0 - pitch_mm + 0.01);
  EXPECT_GE(lead.points[0].norm(), 5.0 - pitch_mm - 0.3);
}

// A ring of 1 mm is 6.28 mm round.
TEST(Leads, AsLongAsAllClosedRunsAreRefused) {
  const auto refusal = [](const LeadSettings& lead) {
    Toolpath toolpath = tube(1.0, 1);
    try {
      addLeads(toolpath, lead);
      return std::string();
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
  };
  const std::string line = refusal(straightLead(6.5));
  EXPECT_EQ(line.find("layer 0 at 0.5 mm, path 1: a lead is 6.5 mm long (lead.length_mm); must be less than "
                      "the longest closed run, 6.28"),
            0U)
      << line;
  EXPECT_EQ(refusal(straightLead(6.2)), "");
  // Beside a longer run a short one does not refuse the part.
  Toolpath both = tube(1.0, 1);
  const Toolpath wide = tube(20.0, 1);
  both.layers[0].paths.insert(both.layers[0].paths.end(), wide.layers[0].paths.begin(),
                              wide.layers[0].paths.end());
  EXPECT_NO_THROW(addLeads(both, straightLead(6.5)));
  LeadSettings arc;
  arc.out = LeadShape::Arc;
  arc.radius_mm = 3.0;
  arc.sweep_deg = 180.0;
  EXPECT_NE(refusal(arc).find("a lead is 9.42478 mm long (lead.radius_mm, lead.sweep_deg)"),
            std::string::npos)
      << refusal(arc);
}

TEST(Leads, DoNotLieAlongTheirOwnBead) {
  // A square that starts amid a side: the tangent is the side.
  Path square = depositedBead({{20, 0, 0.5}, {20, 20, 0.5}, {-20, 20, 0.5}, {-20, -20, 0.5}, {20, -20, 0.5}});
  square.is_closed = true;
  Toolpath toolpath = ofPaths({square});
  const LeadCount count = addLeads(toolpath, straightLead(10.0));
  EXPECT_EQ(count.added, 0U);
  EXPECT_EQ(count.left_out, 2U);
  Toolpath turned = ofPaths({square});
  EXPECT_EQ(addLeads(turned, straightLead(10.0, 30.0)).added, 2U);
}

TEST(Leads, LayNothingAlongABeadThatTheyHardlyLeave) {
  // The end of a tangent of 10 mm is 2.4 mm off a circle of 20 mm: within a bead of 6 mm, off one of 1 mm.
  const auto leadsOf = [](const Bead& bead, LeadDeposit deposit) {
    Path wall = ring(20.0, 2.0, 64);
    wall.bead = bead;
    Toolpath toolpath = ofPaths({wall});
    LeadSettings settings = straightLead(10.0);
    settings.deposit = deposit;
    return addLeads(toolpath, settings);
  };
  EXPECT_EQ(leadsOf({6.0, 2.0}, LeadDeposit::Bead).left_out, 2U);
  EXPECT_EQ(leadsOf({6.0, 2.0}, LeadDeposit::Ramp).left_out, 2U);
  EXPECT_EQ(leadsOf({6.0, 2.0}, LeadDeposit::Dry).added, 2U);
  EXPECT_EQ(leadsOf({1.0, 0.5}, LeadDeposit::Bead).added, 2U);
}

TEST(Leads, StraightOnFromAnOpenBeadMayBeShorterThanItIsWide) {
  Toolpath toolpath = ofPaths({depositedBead({{0, 0, 2}, {30, 0, 2}}, {6.0, 2.0})});
  LeadSettings settings = straightLead(2.0);
  settings.deposit = LeadDeposit::Bead;
  EXPECT_EQ(addLeads(toolpath, settings).added, 2U);
}

TEST(Leads, AreGivenTheRoomOfTheWholeBeadWhereItOverlaps) {
  // Walls 8 mm inside and outside of the start; beads of 6 x 2 mm are packed 5.57 mm apart.
  const Bead section{6.0, 2.0};
  Path wall = ring(20.0, 2.0);
  wall.bead = section;
  const Path outside = depositedBead({{28, -10, 2}, {28, 10, 2}}, section);
  const Path inside = depositedBead({{12, -8, 2}, {12, 8, 2}}, section);
  Toolpath toolpath = ofPaths({wall, travelTo(wall.firstPoint(), outside.points[0]), outside,
                               travelTo(outside.points[1], inside.points[0]), inside});
  LeadSettings settings = straightLead(20.0, 90.0);
  settings.out = LeadShape::None;
  settings.overlap_mm = 10.0;
  EXPECT_EQ(overlapEnds(toolpath, settings), 1U);
  addLeads(toolpath, settings);
  validate(toolpath);
  const Path& lead = toolpath.layers[0].paths[0];
  ASSERT_EQ(lead.role, PathRole::Travel);
  EXPECT_LE(length(lead), 8.0 - planWidth(section) + 0.1);
  EXPECT_GE(length(lead), 1.0);
}

TEST(Leads, LayTheBeadOrOneThatGrowsToIt) {
  Toolpath toolpath = ofPaths({depositedBead({{0, 0, 0.5}, {30, 0, 0.5}})});
  LeadSettings settings = straightLead(6.0);
  settings.deposit = LeadDeposit::Ramp;
  addLeads(toolpath, settings);
  validate(toolpath);
  const Path& in = toolpath.layers[0].paths[0];
  EXPECT_EQ(in.role, PathRole::Prime);
  const double section = crossSection({1.0, 0.5});
  EXPECT_NEAR(depositedVolume(in), 0.5 * 6.0 * section, 1e-9);
  EXPECT_NEAR(crossSection(in.bead.at(1)), 0.05 * section, 1e-9);
  EXPECT_NEAR(crossSection(in.bead.at(10)), 0.95 * section, 1e-9);
  const Path& out = toolpath.layers[0].paths[2];
  EXPECT_NEAR(crossSection(out.bead.at(1)), 0.95 * section, 1e-9);
  EXPECT_NEAR(crossSection(out.bead.at(10)), 0.05 * section, 1e-9);
}

TEST(Entries, ComeAlongTheToolAxis) {
  Path tilted = depositedBead({{0, 0, 0.5}, {30, 0, 0.5}});
  const Eigen::Quaterniond nozzle = Eigen::AngleAxisd(M_PI / 6.0, Point3::UnitY()) * nozzleDown();
  tilted.orientation = nozzle;
  Path travel = travelTo({0, 20, 0.5}, {0, 0, 0.5});
  travel.orientation = nozzle;
  Toolpath toolpath = ofPaths({travel, tilted});
  EntrySettings settings;
  settings.distance_mm = 12.0;
  settings.feed_mm_s = 3.0;
  EXPECT_EQ(addEntries(toolpath, settings), 2U);
  validate(toolpath);
  const auto& paths = toolpath.layers[0].paths;
  ASSERT_EQ(paths.size(), 4U);
  // The tool axis points down and by 30 deg aside: back along it by 12 mm.
  EXPECT_LT((paths[1].points[0] - Point3(6.0, 0.0, 0.5 + 12.0 * std::sqrt(0.75))).norm(), 1e-9);
  EXPECT_EQ(paths[1].feed_mm_s.at(1), 3.0);
  EXPECT_LT((paths[3].points[1] - Point3(36.0, 0.0, 0.5 + 12.0 * std::sqrt(0.75))).norm(), 1e-9);
}

TEST(Entries, ComeToTheDryLeadOfARun) {
  Toolpath toolpath =
      ofPaths({travelTo({0, 20, 0.5}, {0, 0, 0.5}), depositedBead({{0, 0, 0.5}, {30, 0, 0.5}})});
  EntrySettings settings;
  settings.distance_mm = 5.0;  // where the travel comes down from
  addEnds(toolpath, straightLead(6.0), settings);
  validate(toolpath);
  const auto& paths = toolpath.layers[0].paths;
  EXPECT_EQ(paths[0].points.size(), 3U);
  EXPECT_LT((paths[1].points[0] - Point3(-6, 0, 5.5)).norm(), 1e-9);
  EXPECT_LT((paths[1].points[1] - Point3(-6, 0, 0.5)).norm(), 1e-9);
}

TEST(Entries, JoinWhereOneLeadIsLeftOutAndTheOtherIsNot) {
  // The second run starts right beside a wall.
  const Path wall = depositedBead({{49, -10, 0.5}, {49, 10, 0.5}});
  Toolpath toolpath =
      ofPaths({wall, travelTo({49, 10, 0.5}, {0, 0, 0.5}), depositedBead({{0, 0, 0.5}, {30, 0, 0.5}}),
               travelTo({30, 0, 0.5}, {50, 0, 0.5}), depositedBead({{50, 0, 0.5}, {80, 0, 0.5}})});
  EntrySettings settings;
  settings.distance_mm = 3.0;
  const EndCount count = addEnds(toolpath, straightLead(6.0), settings);
  validate(toolpath);
  EXPECT_EQ(count.leads.left_out, 1U);
  EXPECT_EQ(count.leads.added, 5U);
  EXPECT_EQ(count.entries, 6U);
}

TEST(Entries, AreRunByTheToolOfTheirRun) {
  Path run = depositedBead({{0, 0, 0.5}, {30, 0, 0.5}});
  Path travel = travelTo({0, 20, 0.5}, {0, 0, 0.5});
  run.tool = travel.tool = 1;
  Toolpath toolpath = ofPaths({travel, run});
  EntrySettings settings;
  settings.distance_mm = 12.0;
  addEnds(toolpath, straightLead(6.0), settings);
  ASSERT_EQ(toolpath.layers[0].paths.size(), 6U);
  for (const Path& path : toolpath.layers[0].paths) EXPECT_EQ(path.tool, 1U);
}

TEST(Entries, AndDryLeadsKeepTheMaterialPulledBack) {
  const Path run = depositedBead({{0, 0, 0.5}, {30, 0, 0.5}});
  Path to = travelTo({0, 20, 0.5}, run.points[0]);
  Path away = travelTo(run.points[1], {9, 9, 0.5});
  EntrySettings entry;
  entry.distance_mm = 3.0;
  const auto retractionsOf = [&](LeadDeposit deposit) {
    Toolpath toolpath = ofPaths({to, run, away});
    LeadSettings lead = straightLead(6.0);
    lead.deposit = deposit;
    addEnds(toolpath, lead, entry);
    std::vector<bool> retracted;
    for (const Path& path : toolpath.layers[0].paths) retracted.push_back(path.process.is_retracted);
    return retracted;
  };
  EXPECT_EQ(retractionsOf(LeadDeposit::Dry), std::vector<bool>(7, false));
  to.process.is_retracted = away.process.is_retracted = true;
  EXPECT_EQ(retractionsOf(LeadDeposit::Dry), (std::vector<bool>{true, true, true, false, true, true, true}));
  // What lays a bead needs its material.
  EXPECT_EQ(retractionsOf(LeadDeposit::Bead),
            (std::vector<bool>{true, true, false, false, false, true, true}));
}

TEST(Levels, OfAWireFollowFromBeadAndFeed) {
  Toolpath toolpath = ofPaths({depositedBead({{0, 0, 2}, {30, 0, 2}}, {6.0, 2.0})});
  LevelSettings settings;
  settings.values = "laser_power_w=1200, wire_speed_mm_s=from_bead";
  stateLevels(toolpath, settings);
  validate(toolpath);
  const Path& path = toolpath.layers[0].paths[0];
  ASSERT_EQ(path.values.size(), 2U);
  EXPECT_EQ(path.values[0].name, "laser_power_w");
  EXPECT_EQ(path.values[0].value.at(1), 1200.0);
  EXPECT_NEAR(path.values[1].value.at(1), 78.81, 0.01);  // mm/s: 6 x 2 mm at 8 mm/s by wire of 1.2 mm
}

TEST(Levels, RiseAndFallAtTheEndsOfRuns) {
  // Two paths of 20 mm are one run.
  Toolpath toolpath =
      ofPaths({depositedBead({{0, 0, 0.5}, {20, 0, 0.5}}), depositedBead({{20, 0, 0.5}, {20, 20, 0.5}})});
  LevelSettings settings;
  settings.values = "laser_power_w=1000";
  settings.start_share = 0.6;
  settings.start_mm = 8.0;
  settings.end_share = 0.2;
  settings.end_mm = 4.0;
  stateLevels(toolpath, settings);
  validate(toolpath);
  const Path& first = toolpath.layers[0].paths[0];
  const Path& second = toolpath.layers[0].paths[1];
  ASSERT_EQ(first.points.size(), 10U);  // steps of 1 mm to 8 mm, and 20 mm
  EXPECT_NEAR(first.values[0].value.at(1), 1000.0 * (0.6 + 0.4 * 0.5 / 8.0), 1e-9);
  EXPECT_NEAR(first.values[0].value.at(8), 1000.0 * (0.6 + 0.4 * 7.5 / 8.0), 1e-9);
  EXPECT_NEAR(first.values[0].value.at(9), 1000.0, 1e-9);
  ASSERT_EQ(second.points.size(), 10U);
  EXPECT_NEAR(second.values[0].value.at(1), 1000.0, 1e-9);
  EXPECT_NEAR(second.values[0].value.at(2), 1000.0 * (0.2 + 0.8 * 3.75 / 4.0), 1e-9);
  EXPECT_NEAR(second.values[0].value.at(9), 1000.0 * (0.2 + 0.8 * 0.25 / 4.0), 1e-9);
}

}  // namespace
}  // namespace lamina
