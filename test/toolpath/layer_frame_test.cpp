// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/layer_frame.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-12;  // mm

Eigen::Quaterniond tilt() { return Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 4, Point3::UnitX())); }

TEST(LayerFrame, TurningKeepsLengthsAndReportsThePlanes) {
  const Toolpath level = test::twoLayers();
  const Toolpath inclined = turned(level, tilt());
  EXPECT_NO_THROW(validate(inclined));
  EXPECT_NEAR(totals(inclined).deposition_mm, totals(level).deposition_mm, 1e-9);
  EXPECT_NEAR(inclinationDeg(inclined), 45.0, 1e-9);
  const Point3 normal = layerNormal(inclined);
  EXPECT_TRUE(normal.isApprox(Point3(0, -M_SQRT1_2, M_SQRT1_2), kRounding));
  for (const ToolpathLayer& layer : inclined.layers)
    for (const Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      for (const Point3& point : path.points) EXPECT_NEAR(normal.dot(point), layer.z_mm, kRounding);
      EXPECT_TRUE((path.orientation.at(0) * Point3::UnitZ()).isApprox(-normal, kRounding));
    }
}

TEST(LayerFrame, PlacedOnTheBedLayersStayWhereTheirWaypointsAre) {
  Eigen::Isometry3d bed_from_part = Eigen::Translation3d(3, -4, 5) * Eigen::Isometry3d::Identity();
  bed_from_part.rotate(tilt());
  const Toolpath level = test::twoLayers();
  const Toolpath moved = placed(level, bed_from_part);
  EXPECT_NO_THROW(validate(moved));
  EXPECT_TRUE(hasPlaneLayers(moved));
  const Path& first = level.layers[0].paths.back();
  EXPECT_TRUE(moved.layers[0].paths.back().points[1].isApprox(bed_from_part * first.points[1], kRounding));
  EXPECT_TRUE((moved.layers[0].paths.back().orientation.at(0) * Point3::UnitZ())
                  .isApprox(bed_from_part.linear() * (first.orientation.at(0) * Point3::UnitZ()), kRounding));
}

TEST(LayerFrame, InItsOwnFrameALayerIsLevelAgain) {
  const Toolpath level = test::twoLayers();
  const Toolpath back = inLayerFrame(turned(level, tilt()));
  EXPECT_FALSE(isInclined(back));
  for (std::size_t l = 0; l < level.layers.size(); ++l)
    for (std::size_t p = 0; p < level.layers[l].paths.size(); ++p)
      for (std::size_t i = 0; i < level.layers[l].paths[p].points.size(); ++i)
        EXPECT_TRUE(
            (back.layers[l].paths[p].points[i] - level.layers[l].paths[p].points[i]).isZero(kRounding));
}

TEST(LayerFrame, TheNozzleCanBeHeldAnotherWay) {
  const Toolpath upright = withNozzle(turned(test::twoLayers(), tilt()), nozzleDown());
  EXPECT_TRUE(isInclined(upright));
  for (const Path& path : upright.layers[0].paths)
    EXPECT_EQ(path.orientation.at(0).coeffs(), nozzleDown().coeffs());
}

TEST(LayerFrame, WhatNeedsLevelLayersRefusesOthersByTheirAngle) {
  EXPECT_NO_THROW(requireLevelLayers(test::twoLayers(), "the void map"));
  try {
    requireLevelLayers(turned(test::twoLayers(), tilt()), "the void map");
    FAIL() << "inclined layers were taken";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "the void map: the layers of 'square' are inclined by 45.000 deg; level layers are needed");
  }
}

TEST(LayerFrame, TheTurnOfTheLayersChangesTheIdAlone) {
  Toolpath toolpath = test::twoLayers();
  const std::string level = toolpathId(toolpath);
  toolpath.part_from_layers = tilt();
  EXPECT_NE(toolpathId(toolpath), level);
  toolpath.part_from_layers.coeffs() *= 2.0;
  EXPECT_THROW(validate(toolpath), InvalidInput);
}

}  // namespace
}  // namespace lamina
