// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orient_toolpath.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/orientation/no_spin.hpp"
#include "support/directions.hpp"
#include "support/lofted_solid.hpp"
#include "support/random_toolpath.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

OrientedToolpath oriented(const Toolpath& toolpath, const OrientationSettings& settings,
                          const Mesh& part = {}) {
  NoProgress progress;
  return orientToolpath(toolpath, settings, part, progress);
}

/// A random toolpath with random tool axes along some of its runs.
Toolpath withRandomToolAxes(std::uint64_t seed, double max_tilt_deg) {
  Toolpath toolpath = test::randomToolpath(seed);
  Random random(seed + 1);
  for (ToolpathLayer& layer : toolpath.layers) {
    for (Path& path : layer.paths) {
      if (path.role == PathRole::Travel || random.below(2) == 0) continue;
      std::vector<Eigen::Quaterniond> frames;
      while (frames.size() < path.points.size()) {
        const double tilt = random.uniform(0.0, max_tilt_deg) * M_PI / 180.0;
        const double heading = random.uniform(0.0, 2.0 * M_PI);
        const Point3 tool_axis(std::sin(tilt) * std::cos(heading), std::sin(tilt) * std::sin(heading),
                               -std::cos(tilt));
        frames.push_back(shortestRotation(Point3::UnitZ(), tool_axis).normalized());
      }
      path.orientation = AlongPath<Eigen::Quaterniond>(frames);
    }
  }
  return toolpath;
}

template <class Check>
void forEachWaypoint(const Toolpath& toolpath, const Check& check) {
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t i = 0; i < path.points.size(); ++i) check(path, path.orientation.at(i));
}

TEST(OrientToolpath, DefaultsLeaveALevelToolpathAsItIs) {
  const Toolpath given = test::randomToolpath(7);
  const OrientedToolpath result = oriented(given, {});
  EXPECT_EQ(toolpathId(result.toolpath), toolpathId(given));
  EXPECT_EQ(result.report.lean_deg.value, 0.0);
  EXPECT_EQ(result.report.step_deg.value, 0.0);
  EXPECT_TRUE(result.report.limits_hit.empty());
}

TEST(OrientToolpath, PathsOfOneOrientationHoldItOnce) {
  OrientationSettings settings;
  settings.mode = OrientationMode::Fixed;
  settings.fixed = {30.0, 90.0};
  settings.heading_deg = 180.0;
  settings.smoothing_window = 5;
  const OrientedToolpath result = oriented(withRandomToolAxes(3, 50.0), settings);
  forEachWaypoint(result.toolpath, [](const Path& path, const Eigen::Quaterniond& at) {
    EXPECT_TRUE(path.orientation.isCommon());
    EXPECT_LE((toolAxisOf(at) - Point3(0, -0.5, -std::sqrt(0.75))).norm(), 1e-12);
  });
  EXPECT_NEAR(result.report.lean_deg.value, 30.0, 1e-9);
}

TEST(OrientToolpath, ToolAxesStayFramesAreUnitAndSignsSteady) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Toolpath given = withRandomToolAxes(seed, 80.0);
    const Toolpath result = oriented(given, {}).toolpath;
    Eigen::Quaterniond before = result.layers[0].paths[0].orientation.at(0);
    for (std::size_t l = 0; l < given.layers.size(); ++l) {
      for (std::size_t p = 0; p < given.layers[l].paths.size(); ++p) {
        const Path& path = result.layers[l].paths[p];
        for (std::size_t i = 0; i < path.points.size(); ++i) {
          const Eigen::Quaterniond at = path.orientation.at(i);
          RC_ASSERT(std::abs(at.norm() - 1.0) <= 1e-12);
          RC_ASSERT(at.dot(before) >= 0.0);
          before = at;
          if (path.role == PathRole::Travel) continue;
          RC_ASSERT((toolAxisOf(at) - toolAxisOf(given.layers[l].paths[p].orientation.at(i))).norm() <= 1e-9);
        }
        if (path.is_closed) before = path.orientation.at(0);
      }
    }
  }));
}

TEST(OrientToolpath, LimitsAreRespectedAndReported) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    OrientationSettings settings;
    settings.limits.max_lean_deg = 40.0;
    settings.limits.max_turn_deg_per_mm = 2.0;
    const Toolpath given = withRandomToolAxes(seed, 80.0);
    const OrientedToolpath result = oriented(given, settings);
    RC_ASSERT(result.report.lean_deg.value <= 40.0 + 1e-9);
    for (const ToolpathLayer& layer : result.toolpath.layers) {
      for (const Path& path : layer.paths) {
        for (std::size_t m = 0; m < path.motionCount() && path.role != PathRole::Travel; ++m) {
          const std::size_t end = path.motionEnd(m);
          RC_ASSERT(
              test::chordAngleDeg(toolAxisOf(path.orientation.at(m)), toolAxisOf(path.orientation.at(end))) <=
              2.0 * (path.points[end] - path.points[m]).norm() + 1e-6);
        }
      }
    }
    for (const LimitHit& hit : result.report.limits_hit) {
      RC_ASSERT(hit.waypoints > 0U);
      RC_ASSERT(hit.worst.waypoint <
                result.toolpath.layers[hit.worst.layer].paths[hit.worst.path].points.size());
      if (hit.limit == OrientationLimit::Lean) RC_ASSERT(hit.given_deg == 40.0 && hit.wanted_deg > 40.0);
    }
    RC_ASSERT(oriented(given, {}).report.lean_deg.value <= 40.0 || !result.report.limits_hit.empty());
  }));
}

Eigen::Quaterniond tiltedNozzle(double deg) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(deg * M_PI / 180.0, Point3::UnitX()) * nozzleDown());
}

/// Two layers with a travel up, 3 mm over and down between them, to a line along which the nozzle is tilted
/// by 30 deg.
Toolpath travelToATiltedLine(double up_mm) {
  Toolpath toolpath = test::twoLayers();
  const double z = 0.2 + up_mm;
  toolpath.layers[0].paths[1].points = {{0, 0, 0.2}, {0, 0, z}, {0, 3, z}, {0, 3, 0.2}};
  Path& line = toolpath.layers[1].paths[0];
  line.points = {{0, 3, 0.2}, {10, 3, 0.2}};
  line.orientation = tiltedNozzle(30.0);
  return toolpath;
}

void expectTilts(const Path& path, const std::vector<double>& expected_deg) {
  for (std::size_t i = 0; i < expected_deg.size(); ++i)
    EXPECT_NEAR(test::chordAngleDeg(toolAxisOf(path.orientation.at(i)), Point3(0, 0, -1)), expected_deg[i],
                1e-9);
}

TEST(OrientToolpath, TravelsTurnInProportionToTheirLength) {
  const OrientedToolpath result = oriented(travelToATiltedLine(1.0), {});
  expectTilts(result.toolpath.layers[0].paths[1], {0.0, 6.0, 24.0, 30.0});
  EXPECT_NEAR(result.report.travel_deg_per_mm.value, 6.0, 1e-9);
  EXPECT_EQ(result.report.turn_deg_per_mm.value, 0.0);
  EXPECT_NEAR(result.report.step_deg.value, 18.0, 1e-9);
  EXPECT_EQ(result.report.step_deg.at.waypoint, 2U);
}

/// Up with the tool axis held, over while it turns, and down: led so for what is in the way. About the tool
/// axis nothing turns off the shortest way.
TEST(OrientToolpath, TravelsThatLeadTheToolAxisKeepIt) {
  Toolpath toolpath = travelToATiltedLine(5.0);
  toolpath.layers[0].paths[1].orientation =
      AlongPath<Eigen::Quaterniond>({nozzleDown(), nozzleDown(), tiltedNozzle(40.0), tiltedNozzle(30.0)});
  const OrientedToolpath result = oriented(toolpath, {});
  const Path& turned = result.toolpath.layers[0].paths[1];
  expectTilts(turned, {0.0, 0.0, 40.0, 30.0});
  const Path& next = result.toolpath.layers[1].paths[0];
  EXPECT_EQ(turned.orientation.at(3).coeffs(), next.orientation.at(0).coeffs());
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_GT(turned.orientation.at(i).dot(turned.orientation.at(i - 1)), 0.0);
}

TEST(OrientToolpath, OnlyWallsFollowTheWall) {
  const Mesh cone =
      test::loftedSolid({0.0, 20.0}, 360, [](double, double z) { return 20.0 + z * std::tan(M_PI / 6); });
  Toolpath toolpath = test::twoLayers();
  Path& wall = toolpath.layers[0].paths[0];
  wall.points.clear();
  for (int j = 0; j < 360; ++j)
    wall.points.emplace_back(20.0 * std::cos(j * M_PI / 180), 20.0 * std::sin(j * M_PI / 180), 0.2);
  OrientationSettings settings;
  settings.mode = OrientationMode::Wall;
  settings.heading_deg = 180.0;
  const OrientedToolpath result = oriented(toolpath, settings, cone);
  forEachWaypoint(result.toolpath, [](const Path& path, const Eigen::Quaterniond& at) {
    if (path.role == PathRole::OuterWall) {
      EXPECT_NEAR(std::acos(-toolAxisOf(at).z()) * 180.0 / M_PI, 30.0, 0.05);
    } else if (path.role == PathRole::Infill) {
      EXPECT_EQ(at.coeffs(), Eigen::Quaterniond(0, 0, 1, 0).coeffs());
    }
    EXPECT_GE(at.y(), 0.0);
  });
  EXPECT_EQ(result.report.waypoints_without_wall, 0U);
  EXPECT_THROW(oriented(toolpath, settings, Mesh{}), InvalidInput);
}

TEST(OrientToolpath, TheResultDoesNotDependOnThreads) {
  const Toolpath given = test::randomToolpath(5);
  OrientationSettings settings;
  settings.lead_deg = 10.0;
  settings.tilt_deg = -5.0;
  settings.smoothing_window = 3;
  const std::string many = toolpathId(oriented(given, settings).toolpath);
  const ThreadLimit one(1);
  EXPECT_EQ(toolpathId(oriented(given, settings).toolpath), many);
}

TEST(OrientToolpath, AToolAxisAcrossTheHeadingIsRefusedWithItsPlace) {
  Toolpath toolpath = test::twoLayers();
  toolpath.layers[1].paths[0].orientation = shortestRotation(Point3::UnitZ(), Point3::UnitY());
  try {
    oriented(toolpath, {});
    FAIL() << "no refusal";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("layer 1 at 0.4 mm, path 0: "), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace lamina
