// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/tool_point.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(ToolPoint, GoesWhereTheTipWentWithTheToolHeldAsItWas) {
  Path path;
  path.points = {{10, 0, 5}, {20, 0, 5}};
  // Straight down, then leaning by 90 deg: the tool axis along +y.
  const Eigen::Quaterniond down = nozzleDown();
  const Eigen::Quaterniond along_y(Eigen::AngleAxisd(-std::acos(0.0), Point3::UnitX()));
  path.orientation = AlongPath<Eigen::Quaterniond>({down, along_y});
  const Toolpath led = withToolPoint({"pointer", {{5.0, 0.2, {path}}}}, {0, 0, 30});
  const Path& moved = led.layers[0].paths[0];
  EXPECT_LT((moved.points[0] - Point3(10, 0, 35)).norm(), 1e-12) << "30 mm above";
  EXPECT_LT((moved.points[1] - Point3(20, -30, 5)).norm(), 1e-9) << "30 mm behind";
  EXPECT_TRUE(moved.orientation.at(0).isApprox(down));
  const Toolpath same = withToolPoint({"tip", {{5.0, 0.2, {path}}}}, Point3::Zero());
  EXPECT_EQ(same.layers[0].paths[0].points, path.points);
}

}  // namespace
}  // namespace lamina
