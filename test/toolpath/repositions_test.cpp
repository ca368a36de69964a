// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/repositions.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

Path run(PathRole role, const Point3& from, const Point3& to) {
  Path path;
  path.role = role;
  path.points = {from, to};
  return path;
}

ToolpathLayer layerAt(double z, std::vector<Path> paths) {
  ToolpathLayer layer;
  layer.z_mm = z;
  layer.paths = std::move(paths);
  return layer;
}

TEST(Repositions, AreOfThreeClasses) {
  Toolpath toolpath;
  toolpath.layers = {
      layerAt(1, {run(PathRole::OuterWall, {0, 0, 1}, {9, 0, 1}), run(PathRole::Travel, {9, 0, 1}, {1, 1, 1}),
                  run(PathRole::Infill, {1, 1, 1}, {2, 1, 1}), run(PathRole::Travel, {2, 1, 1}, {4, 1, 1}),
                  run(PathRole::Infill, {4, 1, 1}, {5, 1, 1})}),
      layerAt(2, {run(PathRole::OuterWall, {0, 0, 2}, {9, 0, 2})})};
  const Repositions counted = countRepositions(toolpath);
  EXPECT_EQ(counted.to_fill, 1U);
  EXPECT_EQ(counted.in_layer, 1U);
  EXPECT_EQ(counted.to_layer, 1U);
}

TEST(Repositions, AreNotCountedWhereRunsJoin) {
  Toolpath toolpath;
  toolpath.layers = {
      layerAt(1, {run(PathRole::OuterWall, {0, 0, 1}, {9, 0, 1}), run(PathRole::Infill, {9, 0, 1}, {9, 5, 1}),
                  run(PathRole::GapFill, {9, 5, 1}, {9, 6, 1})})};
  const Repositions counted = countRepositions(toolpath);
  EXPECT_EQ(counted.to_fill + counted.in_layer + counted.to_layer, 0U);
}

TEST(Repositions, LeaveSkirtsAndEmptyLayersOut) {
  Toolpath toolpath;
  toolpath.layers = {layerAt(1, {run(PathRole::Skirt, {-5, 0, 1}, {9, -5, 1}),
                                 run(PathRole::OuterWall, {0, 0, 1}, {9, 0, 1})}),
                     layerAt(2, {}), layerAt(3, {run(PathRole::OuterWall, {0, 0, 3}, {9, 0, 3})})};
  const Repositions counted = countRepositions(toolpath);
  EXPECT_EQ(counted.to_fill + counted.in_layer, 0U);
  EXPECT_EQ(counted.to_layer, 1U);
}

}  // namespace
}  // namespace lamina
