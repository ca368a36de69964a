// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/overhang.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kStep = 0.02;       // mm
constexpr double kEnds = 2 * kStep;  // what sampling leaves open at both ends of a stretch
constexpr double kHeight = 50.0;     // mm over the bed: far out of its reach

// Beads are 0.4 x 0.2 mm. One lies on another where its middle is at most half the width of the other and a
// quarter of its own from the middle of the other: 0.3 mm.
constexpr double kHeld = 0.3;

OverhangReport find(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part) {
  OverhangSettings settings;
  settings.step_mm = kStep;
  NoProgress nobody;
  return findOverhangs(toolpath, bed_from_part, settings, nobody);
}

OverhangReport find(const Toolpath& toolpath) { return find(toolpath, Eigen::Isometry3d::Identity()); }

Path overhangTravel(const Path& from, const Path& to) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {from.lastPoint(), to.firstPoint()};
  path.feed_mm_s = 100.0;
  return path;
}

ToolpathLayer layerOf(double z_mm, const std::vector<Path>& paths) {
  ToolpathLayer layer{z_mm, 0.2, {}};
  for (const Path& path : paths) {
    if (!layer.paths.empty()) layer.paths.push_back(overhangTravel(layer.paths.back(), path));
    layer.paths.push_back(path);
  }
  return layer;
}

/// A rail along y at that x, high over the bed.
Path rail(double x) { return test::straightPath({x, -5, kHeight}, {x, 5, kHeight}); }

/// Rails along y, and paths one layer of 0.2 mm above.
Toolpath over(const std::vector<Path>& rails, const std::vector<Path>& paths) {
  return {"rails", {layerOf(kHeight, rails), layerOf(kHeight + 0.2, paths)}};
}

Path across(double from_x, double to_x) {
  return test::straightPath({from_x, 0, kHeight + 0.2}, {to_x, 0, kHeight + 0.2});
}

/// The stretches above the rails, which hang in the air themselves.
std::vector<UnsupportedStretch> upper(const OverhangReport& report) {
  std::vector<UnsupportedStretch> found;
  for (const UnsupportedStretch& stretch : report.stretches)
    if (stretch.at.layer == 1) found.push_back(stretch);
  return found;
}

TEST(Overhang, ABeadFromRailToRailIsABridgeOfTheGapBetweenThem) {
  const auto found = upper(find(over({rail(0), rail(10)}, {across(0, 10)})));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, StretchKind::Bridge);
  EXPECT_FALSE(found[0].begins_run);
  EXPECT_NEAR(found[0].length_mm, 10.0 - 2 * kHeld, kEnds);
  ASSERT_EQ(found[0].points.size(), 2U) << "one motion is one line";
  EXPECT_NEAR(found[0].points.front().x(), kHeld, kEnds);
  EXPECT_NEAR(found[0].points.back().x(), 10.0 - kHeld, kEnds);
}

TEST(Overhang, ABeadThatEndsInTheAirIsAnOverhang) {
  const OverhangReport report = find(over({rail(0)}, {across(0, 10)}));
  ASSERT_EQ(upper(report).size(), 1U);
  EXPECT_EQ(upper(report)[0].kind, StretchKind::Overhang);
  EXPECT_NEAR(upper(report)[0].length_mm, 10.0 - kHeld, kEnds);
  EXPECT_EQ(report.layers[1].starts_in_air, 0U);
  EXPECT_NEAR(report.layers[1].overhang_mm, 10.0 - kHeld, kEnds);
  EXPECT_NEAR(report.layers[1].deposited_mm, 10.0, 1e-9);
}

TEST(Overhang, ABeadThatBeginsInTheAirIsCountedAsAStart) {
  const OverhangReport report = find(over({rail(0)}, {across(10, 0)}));
  ASSERT_EQ(upper(report).size(), 1U);
  EXPECT_TRUE(upper(report)[0].begins_run);
  EXPECT_EQ(upper(report)[0].kind, StretchKind::Overhang);
  EXPECT_EQ(report.layers[1].starts_in_air, 1U);
  EXPECT_EQ(report.runs, 2U);
}

TEST(Overhang, ACurveBetweenTwoRailsIsNoBridge) {
  Path bow = across(0, 10);
  bow.points.insert(bow.points.begin() + 1, {5, 0.5, kHeight + 0.2});
  const auto found = upper(find(over({rail(0), rail(10)}, {bow})));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, StretchKind::Overhang);
  EXPECT_EQ(found[0].at.path, 0U);
  EXPECT_EQ(found[0].at.waypoint, 1U);
}

TEST(Overhang, AStretchGoesOnFromPathToPath) {
  const auto found = upper(
      find({"joined",
            {layerOf(kHeight, {rail(0), rail(10)}), {kHeight + 0.2, 0.2, {across(0, 4), across(4, 10)}}}}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].length_mm, 10.0 - 2 * kHeld, kEnds);
}

TEST(Overhang, WhatIsDepositedLaterCarriesNothing) {
  Toolpath toolpath = over({rail(0), rail(10)}, {across(0, 10)});
  std::swap(toolpath.layers[0], toolpath.layers[1]);
  const OverhangReport report = find(toolpath);
  EXPECT_NEAR(report.layers[0].overhang_mm, 10.0, 1e-9);
  EXPECT_EQ(report.layers[0].bridge_mm, 0.0);
}

TEST(Overhang, NeighboursOfTheSameLayerCarryNothing) {
  const Path beside = test::straightPath({0, 0.2, kHeight + 0.2}, {10, 0.2, kHeight + 0.2});
  const OverhangReport report = find(over({rail(100)}, {across(0, 10), beside}));
  EXPECT_NEAR(report.layers[1].unsupported(), 20.0, 1e-9);
}

TEST(Overhang, TheBedCarriesWhatIsWithinABeadHeightOfTheMiddle) {
  // The middle is 0.1 mm below the tip; 0.2 mm farther down the bed must have come.
  for (const auto& [z, unsupported] : {std::pair{0.2, 0.0}, {0.29, 0.0}, {0.32, 10.0}}) {
    const Toolpath toolpath = {"one", {layerOf(z, {test::straightPath({0, 0, z}, {10, 0, z})})}};
    EXPECT_NEAR(find(toolpath).layers[0].unsupported(), unsupported, 1e-9) << z;
  }
}

TEST(Overhang, TheToolAxisDecidesWhatIsBelow) {
  // Down and along +x at 45 deg: the middles are 0.2 mm apart in depth, so the ray comes 0.2 mm along x.
  const Eigen::Quaterniond inclined =
      Eigen::Quaterniond(Eigen::AngleAxisd(-M_PI / 4, Point3::UnitY())) * nozzleDown();
  ASSERT_NEAR((inclined * Point3::UnitZ()).x(), std::sqrt(0.5), 1e-12);
  for (const auto& [x, is_carried] : {std::pair{0.48, true}, {0.52, false}, {-0.08, true}, {-0.12, false}}) {
    Path above = test::straightPath({0, -4, kHeight + 0.2}, {0, 4, kHeight + 0.2});
    above.orientation = inclined;
    const OverhangReport report = find(over({rail(x)}, {above}));
    EXPECT_NEAR(report.layers[1].unsupported(), is_carried ? 0.0 : 8.0, 1e-9) << x;
  }
}

TEST(Overhang, IsTheSameHoweverTheLayersAreTurnedTogetherWithTheBed) {
  const Toolpath level = over({rail(0), rail(3)}, {across(-1, 3)});
  const OverhangTotals expected = totals(find(level));
  EXPECT_TRUE(rc::check("any rotation", [&](std::uint64_t seed) {
    Random random(seed);
    const auto angle = [&random] { return random.uniform(-M_PI, M_PI); };
    const Eigen::Quaterniond rotation = Eigen::AngleAxisd(angle(), Point3::UnitX()) *
                                        Eigen::AngleAxisd(angle(), Point3::UnitY()) *
                                        Eigen::AngleAxisd(angle(), Point3::UnitZ());
    Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
    bed_from_part.linear() = rotation.conjugate().toRotationMatrix();
    const OverhangTotals found = totals(find(turned(level, rotation), bed_from_part));
    RC_ASSERT(std::abs(found.all.overhang_mm - expected.all.overhang_mm) < kEnds);
    RC_ASSERT(std::abs(found.all.bridge_mm - expected.all.bridge_mm) < kEnds);
    RC_ASSERT(found.all.starts_in_air == expected.all.starts_in_air);
  }));
}

TEST(Overhang, ADropIsAsLongAsItsDiameter) {
  Path drops = across(0, 5);
  drops.deposit = Deposit::Drops;
  const OverhangReport report = find(over({rail(0)}, {drops}));
  EXPECT_NEAR(report.layers[1].deposited_mm, 0.8, 1e-12);
  EXPECT_NEAR(report.layers[1].overhang_mm, 0.4, 1e-12);
  EXPECT_EQ(report.layers[1].starts_in_air, 1U);
}

TEST(Overhang, TotalsNameTheLongestOfEachKindAndTheWorstLayer) {
  const OverhangReport report = find(over({rail(0), rail(4), rail(10)}, {across(0, 10), across(10, 14)}));
  const OverhangTotals sums = totals(report);
  EXPECT_NEAR(sums.longest_bridge_mm, 6.0 - 2 * kHeld, kEnds);
  EXPECT_EQ(sums.bridges, 2U);
  EXPECT_EQ(sums.worst_layer, 0U) << "three rails of 10 mm each";
  EXPECT_NEAR(longest(report, StretchKind::Bridge, 1).at(0).points.front().x(), 4.0 + kHeld, kEnds);
  EXPECT_EQ(longest(report, StretchKind::Overhang, 2).size(), 2U);
  EXPECT_FALSE(totals(find(Toolpath())).worst_layer);
}

TEST(Overhang, AToolAxisAlongTheLayersIsRefused) {
  Path path = across(0, 10);
  path.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(-M_PI / 2, Point3::UnitY())) * nozzleDown();
  try {
    find(over({rail(0)}, {path}));
    FAIL() << "not refused";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("layer 1: the tool axis is inclined by 90"), std::string::npos);
  }
}

}  // namespace
}  // namespace lamina
