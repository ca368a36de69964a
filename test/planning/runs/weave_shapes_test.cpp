// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Circles, eights, and torches that swing.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/program/csv/csv_writer.hpp"

namespace lamina {
namespace {

constexpr double kAmplitude = 2.0;  // mm, every 4 mm
constexpr double kWave = 4.0;

Path weaveable(std::vector<Point3> points) {
  Path path;
  path.role = PathRole::OuterWall;
  path.points = std::move(points);
  path.bead = Bead{6.0, 2.0};
  path.feed_mm_s = 8.0;
  return path;
}

Path straightLine(double length_mm) { return weaveable({{0, 0, 2}, {length_mm, 0, 2}}); }

WeaveSettings shape(WeaveKind kind) {
  WeaveSettings settings;
  settings.kind = kind;
  settings.amplitude_mm = kAmplitude;
  settings.wavelength_mm = kWave;
  settings.tolerance_mm = 0.002;
  return settings;
}

Toolpath layerOf(const Path& path) {
  Toolpath toolpath;
  toolpath.layers = {{2.0, 2.0, {path}}};
  return toolpath;
}

Path wovenBy(const Path& path, const WeaveSettings& settings) {
  Toolpath toolpath = layerOf(path);
  EXPECT_EQ(weave(toolpath, settings, MotionLimits{}), 1U);
  validate(toolpath);
  return toolpath.layers[0].paths[0];
}

std::string weavingRefusal(const Path& path, const WeaveSettings& settings) {
  try {
    wovenBy(path, settings);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

/// Way of the tip from one of its waypoints to another.
double wovenWay(const Path& path, std::size_t from, std::size_t to) {
  double way_mm = 0.0;
  for (std::size_t m = from; m < to; ++m) way_mm += (path.points[m + 1] - path.points[m]).norm();
  return way_mm;
}

TEST(WeaveShapes, CirclesGoRoundAheadOfTheirLine) {
  const Path line = straightLine(100.0);
  const Path path = wovenBy(line, shape(WeaveKind::Circle));
  const std::size_t waves = 25;
  ASSERT_EQ((path.points.size() - 1) % waves, 0U);
  const std::size_t each = (path.points.size() - 1) / waves;
  for (std::size_t i = each; i <= (waves - 1) * each; ++i) {
    const double advance_mm = kWave * static_cast<double>(i) / static_cast<double>(each);
    const Point3 centre(advance_mm + kAmplitude, 0.0, 2.0);
    EXPECT_NEAR((path.points[i] - centre).norm(), kAmplitude, 1e-9) << i;
  }
  // (1 + pi² + 2 pi sin x)^0.5 on average.
  EXPECT_NEAR(wovenWay(path, 5 * each, 20 * each) / 60.0, 3.22169, 2e-3);
  EXPECT_NEAR(depositedVolume(path), depositedVolume(line), 1e-6);
  EXPECT_EQ(path.points.front(), line.points.front());
  EXPECT_EQ(path.points.back(), line.points.back());
  for (const Point3& point : path.points) {
    EXPECT_GE(point.x(), -1e-9);
    EXPECT_LE(point.x(), 100.0 + 1e-9);
  }
  // The feed is that of the advance: each wave takes 0.5 s.
  double time_s = 0.0;
  for (std::size_t i = 5 * each + 1; i <= 6 * each; ++i)
    time_s += (path.points[i] - path.points[i - 1]).norm() / path.feed_mm_s.at(i);
  EXPECT_NEAR(time_s, kWave / 8.0, 1e-9);
}

TEST(WeaveShapes, OpenLinesHoldWholeCirclesAndHalfEights) {
  // 14 mm: three and a half waves of 4 mm.
  const Path circles = wovenBy(straightLine(14.0), shape(WeaveKind::Circle));
  EXPECT_EQ((circles.points.size() - 1) % 4, 0U);  // four waves of 3.5 mm
  const std::size_t each = (circles.points.size() - 1) / 4;
  EXPECT_NEAR(circles.points[each + each / 4].y(), kAmplitude, 1e-9);
  EXPECT_NEAR(circles.points[each + each / 4].x(), 1.25 * 3.5 + kAmplitude, 1e-9);
  const Path eights = wovenBy(straightLine(14.0), shape(WeaveKind::Eight));
  ASSERT_EQ((eights.points.size() - 1) % 7, 0U);
  const std::size_t half = (eights.points.size() - 1) / 7;
  // On the line after each half wave, on the sides amid them.
  EXPECT_LT((eights.points[2 * half] - Point3(4, 0, 2)).norm(), 1e-9);
  EXPECT_LT((eights.points[2 * half + half / 2] - Point3(5, kAmplitude, 2)).norm(), 1e-9);
  EXPECT_LT((eights.points[3 * half + half / 2] - Point3(7, -kAmplitude, 2)).norm(), 1e-9);
  EXPECT_EQ(eights.points.back(), Point3(14, 0, 2));
}

TEST(WeaveShapes, EightsGoHalfAsFarAheadAndBack) {
  const Path line = straightLine(100.0);
  const Path path = wovenBy(line, shape(WeaveKind::Eight));
  const std::size_t each = (path.points.size() - 1) / 25;
  for (std::size_t i = each; i <= 24 * each; ++i) {
    const double turn = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(each);
    const double advance_mm = kWave * static_cast<double>(i) / static_cast<double>(each);
    EXPECT_NEAR(path.points[i].x(), advance_mm + 0.5 * kAmplitude * std::sin(2.0 * turn), 1e-9) << i;
    EXPECT_NEAR(path.points[i].y(), kAmplitude * std::sin(turn), 1e-9) << i;
  }
  EXPECT_NEAR(wovenWay(path, 5 * each, 20 * each) / 60.0, 3.03759, 2e-3);
  EXPECT_NEAR(depositedVolume(path), depositedVolume(line), 1e-6);
}

TEST(WeaveShapes, RingsHoldWholeWavesAndCloseOnTheirLine) {
  std::vector<Point3> points;
  for (int i = 0; i < 360; ++i)
    points.emplace_back(50.0 * std::cos(M_PI * i / 180.0), 50.0 * std::sin(M_PI * i / 180.0), 2.0);
  Path ring = weaveable(points);
  ring.is_closed = true;
  for (const WeaveKind kind : {WeaveKind::Circle, WeaveKind::Eight}) {
    const Path path = wovenBy(ring, shape(kind));
    EXPECT_TRUE(path.is_closed);
    EXPECT_LT((path.points.front() - ring.points.front()).norm(), 1e-9);
    EXPECT_NEAR(depositedVolume(path), depositedVolume(ring), 1e-6);
    EXPECT_EQ(path.points.size() % 79U, 0U);  // 314.15 mm of 4 mm
    double nearest = 1e9;
    double farthest = 0.0;
    for (const Point3& point : path.points) {
      nearest = std::min(nearest, point.head<2>().norm());
      farthest = std::max(farthest, point.head<2>().norm());
    }
    EXPECT_NEAR(nearest, 50.0 - kAmplitude, 0.02);
    EXPECT_NEAR(farthest, 50.0 + kAmplitude, 0.02);
  }
}

TEST(WeaveShapes, RefuseATipThatStandsStill) {
  // 2 pi 0.64 / 4 = 1.005: it goes back as fast as the line goes on.
  for (const WeaveKind kind : {WeaveKind::Circle, WeaveKind::Eight}) {
    WeaveSettings settings = shape(kind);
    settings.amplitude_mm = 0.64;
    const std::string what = weavingRefusal(straightLine(100.0), settings);
    EXPECT_NE(
        what.find("layer 0 at 2 mm, path 0: weave.amplitude_mm is 0.64 mm with waves that are 4 mm long"),
        std::string::npos)
        << what;
    EXPECT_NE(what.find("expected at most 0.530516 mm, or 0.742723 mm or more"), std::string::npos) << what;
    for (const double amplitude_mm : {0.53, 0.75, 2.9}) {
      settings.amplitude_mm = amplitude_mm;
      EXPECT_EQ(weavingRefusal(straightLine(100.0), settings), "") << amplitude_mm;
    }
  }
}

TEST(WeaveShapes, AreJudgedByTheirOwnAccelerations) {
  // Of a circle 2 (2 pi v / 4)², of an eight 17 / 8 times that: 1500 mm/s² at 17.43 and 11.96 mm/s.
  for (const auto& [kind, feed_mm_s] :
       {std::pair{WeaveKind::Circle, 17.43}, std::pair{WeaveKind::Eight, 11.96}}) {
    Path line = straightLine(100.0);
    line.feed_mm_s = feed_mm_s - 0.02;
    EXPECT_EQ(weavingRefusal(line, shape(kind)), "");
    line.feed_mm_s = feed_mm_s + 0.02;
    EXPECT_NE(weavingRefusal(line, shape(kind)).find("expected motion.acceleration_mm_s2, 1500"),
              std::string::npos);
  }
  // A tip at its own feed goes round a circle slower: at most by 1 / (pi - 1)² of that.
  WeaveSettings settings = shape(WeaveKind::Circle);
  settings.feed = WeaveFeed::Tip;
  Path line = straightLine(100.0);
  line.feed_mm_s = 17.43 * (M_PI - 1.0) - 0.05;
  EXPECT_EQ(weavingRefusal(line, settings), "");
  line.feed_mm_s = 17.43 * (M_PI - 1.0) + 0.05;
  EXPECT_NE(weavingRefusal(line, settings).find("expected motion.acceleration_mm_s2"), std::string::npos);
}

TEST(SwungTorch, TurnsItsToolAxisToTheSideOnWhichTheTipIs) {
  WeaveSettings settings = shape(WeaveKind::Sine);
  const Path still = wovenBy(straightLine(100.0), settings);
  settings.swing_deg = 15.0;
  const Path path = wovenBy(straightLine(100.0), settings);
  ASSERT_EQ(path.points.size(), still.points.size());
  double greatest = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    EXPECT_EQ(path.points[i], still.points[i]);
    const double angle = toRadians(15.0) * path.points[i].y() / kAmplitude;
    const Point3 tool_axis = path.orientation.at(i) * Point3::UnitZ();
    EXPECT_LT((tool_axis - Point3(0.0, std::sin(angle), -std::cos(angle))).norm(), 1e-9) << i;
    greatest = std::max(greatest, tool_axis.y());
  }
  EXPECT_NEAR(greatest, std::sin(toRadians(15.0)), 1e-9);
  EXPECT_LT(path.orientation.at(0).angularDistance(nozzleDown()), 1e-9);
  EXPECT_LT(path.orientation.at(path.points.size() - 1).angularDistance(nozzleDown()), 1e-9);
  settings.swing_deg = -15.0;
  const Path other = wovenBy(straightLine(100.0), settings);
  for (std::size_t i = 0; i < path.points.size(); ++i)
    EXPECT_NEAR((other.orientation.at(i) * Point3::UnitZ()).y(),
                -(path.orientation.at(i) * Point3::UnitZ()).y(), 1e-9);
}

TEST(SwungTorch, KeepsItsLeanAlongTheWay) {
  Path line = straightLine(40.0);
  line.orientation = Eigen::AngleAxisd(toRadians(-10.0), Point3::UnitY()) * nozzleDown();
  WeaveSettings settings = shape(WeaveKind::Circle);
  settings.swing_deg = 20.0;
  const Path path = wovenBy(line, settings);
  for (std::size_t i = 0; i < path.points.size(); ++i)
    EXPECT_NEAR((path.orientation.at(i) * Point3::UnitZ()).x(), std::sin(toRadians(10.0)), 1e-9);
}

TEST(SwungTorch, StandsInCsvWaypointByWaypoint) {
  WeaveSettings settings = shape(WeaveKind::Zigzag);
  settings.swing_deg = 12.0;
  const Toolpath toolpath = layerOf(wovenBy(straightLine(20.0), settings));
  const Path& path = toolpath.layers[0].paths[0];
  std::string text;
  writeCsv(toolpath, [&text](std::string_view part) { text += part; });
  const Toolpath back = readCsv(text, "woven.csv");
  const Path& read = back.layers[0].paths[0];
  ASSERT_EQ(read.points.size(), path.points.size());
  for (std::size_t i = 0; i < path.points.size(); ++i)
    EXPECT_LT(read.orientation.at(i).angularDistance(path.orientation.at(i)), 1e-9);
  EXPECT_NEAR((read.orientation.at(1) * Point3::UnitZ()).y(), std::sin(toRadians(12.0)), 1e-9);
}

TEST(SwungTorch, IsRefusedWithoutAWeave) {
  BeadRunSettings runs;
  runs.weave.swing_deg = 10.0;
  try {
    requireConsistent(runs);
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("weave.swing_deg is 10 deg with weave.kind 'none'"),
              std::string::npos);
  }
  runs.weave.kind = WeaveKind::Sine;
  EXPECT_NO_THROW(requireConsistent(runs));
}

/// Bends by 25 deg at most, 30 to 60 mm apart.
Path wanderingLine(Random& random) {
  std::vector<Point3> points{{0, 0, 2}};
  double heading = random.uniform(0.0, 2.0 * M_PI);
  for (std::size_t count = 1 + random.below(4); count > 0; --count) {
    points.push_back(points.back() +
                     random.uniform(30.0, 60.0) * Point3(std::cos(heading), std::sin(heading), 0.0));
    heading += random.uniform(-0.4, 0.4);
  }
  return weaveable(std::move(points));
}

TEST(WeaveShapes, LayTheVolumeOfTheLineAndEndOnIt) {
  EXPECT_TRUE(rc::check("all kinds, on lines that bend, with torches that swing", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Path line = wanderingLine(random);
    WeaveSettings settings = shape(*rc::gen::element(WeaveKind::Zigzag, WeaveKind::Sine, WeaveKind::Trapezium,
                                                     WeaveKind::Circle, WeaveKind::Eight));
    settings.amplitude_mm = random.uniform(1.2, 3.0);
    settings.wavelength_mm = random.uniform(3.0, 6.0);
    settings.tolerance_mm = 0.02;
    settings.swing_deg = *rc::gen::element(0.0, 18.0);
    Toolpath toolpath = layerOf(line);
    MotionLimits limits;
    limits.acceleration_mm_s2 = 1e5;
    try {
      weave(toolpath, settings, limits);
    } catch (const InvalidInput& error) {
      // Amplitudes of a sixth of a wave, at which the tip stands still, and bends on whose inside it does.
      const std::string what = error.what();
      RC_ASSERT(what.find("stands still") != std::string::npos ||
                what.find("in a bend") != std::string::npos);
      RC_DISCARD("refused");
    }
    validate(toolpath);
    const Path& path = toolpath.layers[0].paths[0];
    RC_ASSERT(std::abs(depositedVolume(path) - depositedVolume(line)) < 1e-6 * depositedVolume(line));
    RC_ASSERT(path.points.front() == line.points.front() && path.points.back() == line.points.back());
    for (std::size_t i = 0; i < path.points.size(); ++i)
      RC_ASSERT(path.orientation.at(i).angularDistance(nozzleDown()) <= toRadians(settings.swing_deg) + 1e-9);
  }));
}

TEST(RestsOfAWeave, AreRefusedWithoutAWeave) {
  for (const bool is_left : {true, false}) {
    BeadRunSettings runs;
    (is_left ? runs.weave.left_s : runs.weave.right_s) = 0.25;
    try {
      requireConsistent(runs);
      FAIL();
    } catch (const InvalidConfig& error) {
      EXPECT_EQ(
          std::string(error.what()),
          std::string(is_left ? "weave.left_s" : "weave.right_s") +
              " is 0.25 s with weave.kind 'none'; expected 0 s, or a weave: the tip rests on its sides");
    }
    runs.weave.kind = WeaveKind::Sine;
    EXPECT_NO_THROW(requireConsistent(runs));
  }
}

}  // namespace
}  // namespace lamina
