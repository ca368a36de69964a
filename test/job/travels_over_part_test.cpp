// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/travels_over_part.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "planning/nozzle_frame.hpp"

namespace lamina {
namespace {

/// A wall across x, 2 mm thick and 30 mm high, deposited first.
struct Wall final : HeadRoom::Growth {
  double at(const Point3& place) const override {
    const bool is_in = std::abs(place.x()) < 1.0 && place.z() > 0.0 && place.z() < 30.0;
    return is_in ? 0.0 : std::numeric_limits<double>::infinity();
  }
};

HeadRoom roomAtWall() { return {std::make_shared<const Wall>(), {{3.0, 60.0, 5.0}}, 0.0}; }

Path wayBetween(const Point3& from, const Point3& from_axis, const Point3& to, const Point3& to_axis) {
  Path way;
  way.role = PathRole::Travel;
  way.points = {from, to};
  way.orientation = AlongPath<Eigen::Quaterniond>({nozzleAgainst(from_axis), nozzleAgainst(to_axis)});
  way.feed_mm_s = 100.0;
  return way;
}

/// A bead up to 30 mm, and then the way.
Toolpath toolpathWith(const Path& way) {
  Path bead;
  bead.points = {{-40.0, 0.0, 30.0}, way.points.front()};
  bead.bead = Bead{0.4, 0.2};
  bead.feed_mm_s = 20.0;
  Toolpath toolpath;
  toolpath.layers.resize(1);
  toolpath.layers[0].paths = {bead, way};
  return toolpath;
}

TravelsOverPart lead(Toolpath& toolpath) {
  NoProgress nobody;
  return leadTravels(toolpath, {1.0}, roomAtWall(), 2.0, nobody);
}

TEST(TravelsOverPart, StayWhereTheyAreClear) {
  const Path way = wayBetween({-30, 0, 10}, Point3::UnitZ(), {-15, 0, 10}, Point3::UnitZ());
  Toolpath toolpath = toolpathWith(way);
  const TravelsOverPart reported = lead(toolpath);
  EXPECT_EQ(reported.travels, 1U);
  EXPECT_EQ(reported.led_round, 0U);
  EXPECT_EQ(toolpath.layers[0].paths[1].points, way.points);
}

TEST(TravelsOverPart, GoOverAWall) {
  Toolpath toolpath = toolpathWith(wayBetween({-15, 0, 10}, Point3::UnitZ(), {15, 0, 10}, Point3::UnitZ()));
  const TravelsOverPart reported = lead(toolpath);
  EXPECT_EQ(reported.led_round, 1U);
  EXPECT_EQ(reported.shut, 0U);
  const Path& way = toolpath.layers[0].paths[1];
  EXPECT_EQ(way.firstPoint(), Point3(-15, 0, 10));
  EXPECT_EQ(way.lastPoint(), Point3(15, 0, 10));
  // Over the bead at 30 mm, by the hop of 2 mm: wherever the wall is crossed.
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    const bool crosses = way.points[i - 1].x() * way.points[i].x() < 0.0;
    EXPECT_TRUE(!crosses || std::min(way.points[i - 1].z(), way.points[i].z()) > 32.0 - 1e-9) << i;
  }
  EXPECT_NO_THROW(validate(toolpath));
}

// The nozzle itself would swing into what it has deposited.
TEST(TravelsOverPart, TurnAwayFromWhatIsDeposited) {
  const Point3 leaning(0.0, std::sin(1.0), std::cos(1.0));
  Toolpath toolpath = toolpathWith(wayBetween({-30, 0, 40}, leaning, {-25, 0, 40}, Point3::UnitZ()));
  const TravelsOverPart reported = lead(toolpath);
  EXPECT_EQ(reported.led_round, 1U);
  const Path& way = toolpath.layers[0].paths[1];
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    const double turn = way.orientation.at(i - 1).angularDistance(way.orientation.at(i));
    const double out_mm = (way.points[i] - way.points.front()).norm();
    EXPECT_TRUE(turn <= 0.35 || out_mm > 6.0 - 1e-9) << i;
  }
}

// Out of the wall itself there is none.
TEST(TravelsOverPart, WithoutAWayStayAndAreCounted) {
  const Path way = wayBetween({0.0, 0.0, 10}, Point3::UnitZ(), {15, 0, 10}, Point3::UnitZ());
  Toolpath toolpath = toolpathWith(way);
  const TravelsOverPart reported = lead(toolpath);
  EXPECT_EQ(reported.led_round, 1U);
  EXPECT_EQ(reported.shut, 1U);
  EXPECT_EQ(toolpath.layers[0].paths[1].points, way.points);
}

}  // namespace
}  // namespace lamina
