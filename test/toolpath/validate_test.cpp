// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "lamina/base/error.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What `validate` says of two sound layers after a change; empty if it accepts them.
std::string refusalAfter(const std::function<void(Path& wall)>& change) {
  Toolpath toolpath = test::twoLayers();
  change(toolpath.layers[0].paths[0]);
  try {
    validate(toolpath);
    return {};
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

TEST(Validate, AcceptsASoundToolpathAndAnEmptyOne) {
  EXPECT_NO_THROW(validate(test::twoLayers()));
  EXPECT_NO_THROW(validate({}));
  EXPECT_NO_THROW(validate({"part", {{0.2, 0.2, {}}}}));
}

TEST(Validate, RefusesFewerThanTwoPoints) {
  EXPECT_NE(refusalAfter([](Path& wall) { wall.points.resize(1); }), "");
  EXPECT_NE(refusalAfter([](Path& wall) { wall.points.clear(); }), "");
}

TEST(Validate, RefusesWhatIsNotFinite) {
  EXPECT_NE(refusalAfter([](Path& wall) { wall.points[2].y() = kNan; }), "");
  EXPECT_NE(refusalAfter([](Path& wall) { wall.points[2].y() = kInfinity; }), "");
  EXPECT_NE(refusalAfter([](Path& wall) { wall.bead = Bead{kNan, 0.2}; }), "");
  EXPECT_NE(refusalAfter([](Path& wall) { wall.feed_mm_s = kInfinity; }), "");
}

TEST(Validate, RefusesQuantitiesThatFitNoWaypoints) {
  EXPECT_NE(refusalAfter([](Path& wall) {
              wall.feed_mm_s = AlongPath<double>(std::vector<double>{1, 2, 3});
            }),
            "");
  EXPECT_NE(refusalAfter([](Path& wall) { wall.bead = AlongPath<Bead>(std::vector<Bead>{}); }), "");
  EXPECT_EQ(refusalAfter([](Path& wall) { wall.feed_mm_s = AlongPath<double>({1, 2, 3, 4}); }), "");
}

TEST(Validate, RefusesAFeedOfNothingAndANegativeBead) {
  EXPECT_NE(refusalAfter([](Path& wall) { wall.feed_mm_s = 0.0; }), "");
  EXPECT_NE(refusalAfter([](Path& wall) { wall.bead = Bead{-0.1, 0.2}; }), "");
}

TEST(Validate, RefusesAnOrientationThatIsNoRotation) {
  EXPECT_NE(refusalAfter([](Path& wall) { wall.orientation = Eigen::Quaterniond(0, 0, 0, 0); }), "");
}

TEST(Validate, RefusesPathsThatDoNotJoinNamingLayerAndPath) {
  Toolpath toolpath = test::twoLayers();
  toolpath.layers[1].paths[0].points[0].x() += 0.01;
  try {
    validate(toolpath);
    FAIL() << "nothing thrown";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("layer 1, path 0"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamina
