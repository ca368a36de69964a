// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/planning/runs/runs.hpp"

namespace lamina {
namespace {

const Bead kWide = {6.0, 2.0};

Path wide(std::vector<Point3> points) {
  Path path;
  path.role = PathRole::OuterWall;
  path.points = std::move(points);
  path.bead = kWide;
  path.feed_mm_s = 8.0;
  return path;
}

WeaveSettings weaveOf(WeaveKind kind) {
  WeaveSettings settings;
  settings.kind = kind;
  settings.tolerance_mm = 0.002;
  return settings;
}

Path woven(const Path& path, const WeaveSettings& settings, std::size_t expected = 1) {
  Toolpath toolpath;
  toolpath.layers = {{2.0, 2.0, {path}}};
  EXPECT_EQ(weave(toolpath, settings, MotionLimits{}), expected);
  validate(toolpath);
  return toolpath.layers[0].paths[0];
}

std::string weaveRefusal(const Path& path, const WeaveSettings& settings) {
  try {
    woven(path, settings);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

std::size_t crossings(const Path& path) {
  std::size_t count = 0;
  double last = 0.0;
  for (const Point3& point : path.points) {
    if (last * point.y() < 0.0) ++count;
    if (std::abs(point.y()) > 1e-9) last = point.y();
  }
  return count;
}

TEST(Weaving, SineOf2By4Goes230MmIn25Waves) {
  const Path straight = wide({{0, 0, 2}, {100, 0, 2}});
  const Path path = woven(straight, weaveOf(WeaveKind::Sine));
  EXPECT_EQ(crossings(path), 49U);
  EXPECT_NEAR(length(path), 230.5, 0.23);
  EXPECT_NEAR(depositedVolume(path), depositedVolume(straight), 1e-6);
  EXPECT_EQ(path.points.front(), straight.points.front());
  EXPECT_EQ(path.points.back(), straight.points.back());
  double greatest = 0.0;
  for (const Point3& point : path.points) greatest = std::max(greatest, std::abs(point.y()));
  EXPECT_NEAR(greatest, 2.0, 1e-9);
}

TEST(Weaving, FeedIsThatOfTheAdvanceOrOfTheTip) {
  const Path straight = wide({{0, 0, 2}, {100, 0, 2}});
  WeaveSettings settings = weaveOf(WeaveKind::Zigzag);
  const Path advancing = woven(straight, settings);
  // Each millimetre of advance takes 2 mm aside.
  EXPECT_NEAR(length(advancing), 223.607, 0.01);
  EXPECT_NEAR(advancing.feed_mm_s.at(5), 8.0 * std::sqrt(5.0), 1e-9);
  settings.feed = WeaveFeed::Tip;
  EXPECT_NEAR(woven(straight, settings).feed_mm_s.at(5), 8.0, 1e-12);
}

TEST(Weaving, FitsWholeHalfWaves) {
  const Path path = woven(wide({{0, 0, 2}, {15.2, 0, 2}}), weaveOf(WeaveKind::Zigzag));
  EXPECT_EQ(crossings(path), 7U);  // 8 halves of 1.9 mm
  EXPECT_NEAR(path.points[1].x(), 0.95, 1e-9);
  EXPECT_NEAR(path.points[1].y(), 2.0, 1e-9);
  EXPECT_NEAR(path.points[3].y(), -2.0, 1e-9);
}

TEST(Weaving, ClosedRunsHaveWholeWaves) {
  std::vector<Point3> points;
  for (int i = 0; i < 720; ++i) {
    const double angle = M_PI * i / 360.0;
    points.emplace_back(50.0 * std::cos(angle), 50.0 * std::sin(angle), 2.0);
  }
  Path ring = wide(points);
  ring.is_closed = true;
  const Path path = woven(ring, weaveOf(WeaveKind::Sine));
  EXPECT_TRUE(path.is_closed);
  EXPECT_EQ(path.points.front(), ring.points.front());
  std::size_t peaks = 0;
  const std::size_t count = path.points.size();
  const auto radius = [&](std::size_t i) { return path.points[i % count].head<2>().norm(); };
  for (std::size_t i = 0; i < count; ++i)
    if (radius(i + 1) > radius(i) && radius(i + 1) >= radius(i + 2) && radius(i + 1) > 51.9) ++peaks;
  EXPECT_EQ(peaks, 79U);  // 314.158 mm of 4 mm: 78.54 waves
  EXPECT_NEAR(depositedVolume(path), depositedVolume(ring), 1e-6);
  EXPECT_NEAR(path.points[0].head<2>().norm(), 50.0, 1e-9);
}

TEST(Weaving, TrapeziaKeepToTheSides) {
  WeaveSettings settings = weaveOf(WeaveKind::Trapezium);
  settings.flat_share = 0.25;
  const Path path = woven(wide({{0, 0, 2}, {100, 0, 2}}), settings);
  // Each half wave of 2 mm: 0.5 mm across, 1 mm on, 0.5 mm across.
  EXPECT_LT((path.points[4] - Point3(2.5, -2, 2)).norm(), 1e-9);
  EXPECT_LT((path.points[5] - Point3(3.5, -2, 2)).norm(), 1e-9);
}

TEST(Weaving, RestsOnItsSides) {
  WeaveSettings settings = weaveOf(WeaveKind::Zigzag);
  settings.left_s = 0.2;
  settings.right_s = 0.3;
  const Path path = woven(wide({{0, 0, 2}, {8, 0, 2}}), settings);
  ASSERT_EQ(path.events.size(), 4U);
  EXPECT_EQ(path.events[0].motion, 1U);
  EXPECT_NEAR(path.points[1].y(), 2.0, 1e-9);  // left of the way
  EXPECT_EQ(std::get<Dwell>(path.events[0].event).duration_s, 0.2);
  EXPECT_EQ(path.events[1].motion, 3U);
  EXPECT_EQ(std::get<Dwell>(path.events[1].event).duration_s, 0.3);
}

TEST(Weaving, GoesOnRoundTheInsideOfCorners) {
  // A square, and a polygon of corners closer together than waves.
  for (const int sides : {4, 64}) {
    std::vector<Point3> points;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * M_PI * i / sides;
      points.emplace_back(47.3 * std::cos(angle), 47.3 * std::sin(angle), 2.0);
    }
    Path polygon = wide(points);
    polygon.is_closed = true;
    const Path path = woven(polygon, weaveOf(WeaveKind::Sine));
    EXPECT_NEAR(depositedVolume(path), depositedVolume(polygon), 1e-6);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      EXPECT_GT(path.feed_mm_s.at(path.motionEnd(m)), 0.3 * 8.0) << sides << " sides, motion " << m;
      EXPECT_GT((path.points[path.motionEnd(m)] - path.points[m]).norm(), 0.02);
    }
  }
}

TEST(Weaving, LeavesTravelsAndShortPaths) {
  Path travel = wide({{0, 0, 2}, {100, 0, 2}});
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  EXPECT_EQ(woven(travel, weaveOf(WeaveKind::Sine), 0).points.size(), 2U);
  EXPECT_EQ(woven(wide({{0, 0, 2}, {0.9, 0, 2}}), weaveOf(WeaveKind::Sine), 0).points.size(), 2U);
}

/// Round the origin, with corners every 5 deg.
Path wideRing(double radius_mm) {
  std::vector<Point3> points;
  for (int i = 0; i < 72; ++i) {
    const double angle = M_PI * i / 36.0;
    points.emplace_back(radius_mm * std::cos(angle), radius_mm * std::sin(angle), 2.0);
  }
  Path ring = wide(points);
  ring.is_closed = true;
  return ring;
}

TEST(Weaving, LeavesShortPathsWhateverTheirBead) {
  Path stub = wide({{0, 0, 2}, {0.9, 0, 2}});
  stub.bead = Bead{1.0, 2.0};
  stub.feed_mm_s = 100.0;
  EXPECT_EQ(woven(stub, weaveOf(WeaveKind::Sine), 0).points.size(), 2U);
}

TEST(Weaving, JudgesTheWavesThatFitIntoThePath) {
  // 1.1 mm hold half a wave of 2.2 mm: 2 (2 pi 16 / 2.2)² = 4176 mm/s², of 4 mm 1263 mm/s².
  Path stub = wide({{0, 0, 2}, {1.1, 0, 2}});
  stub.feed_mm_s = 16.0;
  const std::string what = weaveRefusal(stub, weaveOf(WeaveKind::Sine));
  EXPECT_NE(what.find("every 2.2 mm at 16 mm/s takes 4176"), std::string::npos) << what;
  // An amplitude of two wavelengths of the settings is four of the one that fits.
  WeaveSettings settings = weaveOf(WeaveKind::Sine);
  settings.wavelength_mm = 1.0;
  stub.points[1].x() = 0.26;
  stub.feed_mm_s = 0.1;
  EXPECT_NE(weaveRefusal(stub, settings).find("weave.amplitude_mm is 2 mm with waves that are 0.52 mm long"),
            std::string::npos);
}

TEST(Weaving, RefusesBendsInWhichTheTipStandsStill) {
  const std::string what = weaveRefusal(wideRing(2.0), weaveOf(WeaveKind::Sine));
  EXPECT_NE(what.find("layer 0 at 2 mm, path 0: motion "), std::string::npos) << what;
  EXPECT_NE(what.find("2 mm (weave.amplitude_mm) aside in a bend"), std::string::npos) << what;
  EXPECT_EQ(weaveRefusal(wideRing(6.0), weaveOf(WeaveKind::Sine)), "");
}

TEST(Weaving, RefusesWhatDoesNotFitBeadOrMachine) {
  WeaveSettings settings = weaveOf(WeaveKind::Sine);
  settings.amplitude_mm = 3.1;
  EXPECT_NE(
      weaveRefusal(wide({{0, 0, 2}, {100, 0, 2}}), settings)
          .find("layer 0 at 2 mm, path 0: weave.amplitude_mm is 3.1 mm, twice which is more than the bead's "
                "width, 6 mm"),
      std::string::npos);
  settings.amplitude_mm = 2.0;
  Path fast = wide({{0, 0, 2}, {100, 0, 2}});
  fast.feed_mm_s = 20.0;  // 2 (2 pi 20 / 4)² = 1974 mm/s²
  const std::string what = weaveRefusal(fast, settings);
  EXPECT_NE(what.find("takes 1973.9"), std::string::npos) << what;
  EXPECT_NE(what.find("motion.acceleration_mm_s2, 1500"), std::string::npos) << what;
  // On its crest a sine turns by 4.93 / mm whichever feed is kept: 20² 4.93.
  settings.feed = WeaveFeed::Tip;
  EXPECT_NE(weaveRefusal(fast, settings).find("takes 1973.9"), std::string::npos);
  // A zigzag at 20 mm/s of its tip advances by 20 / 5^0.5 mm/s: 2 (2 pi 8.944 / 4)² = 395 mm/s².
  settings.kind = WeaveKind::Zigzag;
  EXPECT_EQ(weaveRefusal(fast, settings), "");
  settings.feed = WeaveFeed::Advance;
  EXPECT_NE(weaveRefusal(fast, settings).find("takes 1973.9"), std::string::npos);
  BeadRunSettings runs;
  runs.weave = settings;
  runs.weave.wavelength_mm = 0.9;
  EXPECT_THROW(requireConsistent(runs), InvalidConfig);
}

}  // namespace
}  // namespace lamina
