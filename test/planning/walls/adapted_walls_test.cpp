// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/walls/adapted_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "support/lofted_solid.hpp"

namespace lamina {
namespace {

/// A wall of 45 degrees at phi = 0 that is vertical at 180, in layers of 0.8 mm.
Toolpath adaptedWallsPlanned(const PlanSettings& settings) {
  const Mesh mesh = test::loftedSolid(
      {0.0, 12.0}, 120, [](double phi, double z) { return 20.0 + z * (1.0 + std::cos(phi)) / 2.0; });
  SlicingSettings slicing;
  slicing.layer_height_mm = 0.8;
  slicing.first_layer_height_mm = 0.8;
  NoProgress progress;
  Toolpath toolpath;
  toolpath.part_name = "leaning";
  toolpath.layers = adaptedWalls(adaptedLayers(mesh, slicing, {}, progress), settings);
  return toolpath;
}

TEST(AdaptedWalls, AreAToolpathOfOneWallPerLayer) {
  PlanSettings settings;
  settings.bead.width_mm = 1.2;
  const Toolpath toolpath = adaptedWallsPlanned(settings);
  EXPECT_NO_THROW(validate(toolpath));
  bool is_any_open = false;
  for (const ToolpathLayer& layer : toolpath.layers) {
    EXPECT_NEAR(layer.height_mm, 0.8, 1e-9);
    for (const Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      EXPECT_EQ(path.role, PathRole::OuterWall);
      EXPECT_EQ(path.bead.at(0).width_mm, 1.2);
      is_any_open = is_any_open || !path.is_closed;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        EXPECT_LE(path.points[i].z(), layer.z_mm);
        const Point3 tool_axis = path.orientation.at(i) * Point3::UnitZ();
        EXPECT_LE(std::acos(-tool_axis.z()) * 180.0 / M_PI, 45.0 + 0.05);
      }
    }
  }
  EXPECT_TRUE(is_any_open);
}

/// Farthest waypoint of the first layer from the axis of a cylinder of 20 mm.
double radiusOf(double contour_offset) {
  const Mesh mesh = test::loftedSolid({0.0, 4.0}, 360, [](double, double) { return 20.0; });
  NoProgress progress;
  PlanSettings settings;
  settings.bead.width_mm = 1.2;
  settings.adapted.contour_offset = contour_offset;
  double radius = 0.0;
  const auto walls = adaptedWalls(adaptedLayers(mesh, {}, {}, progress), settings);
  for (const Path& path : walls.at(0).paths)
    for (const Point3& point : path.points) radius = std::max(radius, point.head<2>().norm());
  return radius;
}

TEST(AdaptedWalls, BeadsLieInsideTheWall) {
  EXPECT_NEAR(radiusOf(0.0), 20.0, 1e-3);
  EXPECT_NEAR(radiusOf(0.5), 20.0 - 0.6, 1e-3);
}

TEST(AdaptedWalls, PartsThinnerThanABeadAreRefused) {
  const Mesh mesh = test::loftedSolid({0.0, 4.0}, 60, [](double, double) { return 0.5; });
  NoProgress progress;
  PlanSettings settings;
  settings.bead.width_mm = 1.2;
  EXPECT_THROW(adaptedWalls(adaptedLayers(mesh, {}, {}, progress), settings), InvalidInput);
}

TEST(AdaptedWalls, LoopsStartWhereTheSeamIs) {
  PlanSettings settings;
  settings.seam.placement = SeamPlacement::Rear;
  const Toolpath toolpath = adaptedWallsPlanned(settings);
  std::size_t loops = 0;
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths) {
      if (!path.is_closed) continue;
      ++loops;
      for (const Point3& point : path.points) EXPECT_LE(point.y(), path.points[0].y());
    }
  }
  EXPECT_GT(loops, 0U);
}

}  // namespace
}  // namespace lamina
