// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/planar/layer_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/slicing/planar/layer_stack.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kRadians = M_PI / 180.0;
constexpr double kRounding = 1e-12;  // mm

PlaneSettings plane(double angle_deg, double axis_heading_deg) {
  return {angle_deg, axis_heading_deg, ToolAxis::Normal};
}

TEST(LayerPlane, TurnsAsTheDocumentedRotation) {
  // By [Garcia2024, eq. 4.1 to 4.3]: a point at (10, 20, 30) turned by +45 deg about x, y and -45 deg about
  // x.
  const Point3 point(10, 20, 30);
  EXPECT_TRUE((partFromLayers(plane(45, 0)) * point).isApprox(Point3(10, -5 * M_SQRT2, 25 * M_SQRT2)));
  EXPECT_TRUE((partFromLayers(plane(45, 90)) * point).isApprox(Point3(20 * M_SQRT2, 20, 10 * M_SQRT2)));
  EXPECT_TRUE((partFromLayers(plane(45, 180)) * point).isApprox(Point3(10, 25 * M_SQRT2, 5 * M_SQRT2)));
}

TEST(LayerPlane, NormalLeansAwayFromTheDirectionOfTheAxis) {
  const double s = std::sin(30 * kRadians);
  const double c = std::cos(30 * kRadians);
  EXPECT_TRUE((partFromLayers(plane(30, 0)) * Point3::UnitZ()).isApprox(Point3(0, -s, c), kRounding));
  EXPECT_TRUE((partFromLayers(plane(30, 90)) * Point3::UnitZ()).isApprox(Point3(s, 0, c), kRounding));
}

TEST(LayerPlane, NoAngleIsTheIdentityToTheLastBit) {
  EXPECT_EQ(partFromLayers(plane(0, 33)).coeffs(), Eigen::Quaterniond::Identity().coeffs());
}

TEST(LayerPlane, TurnsAMeshInItsOwnMemory) {
  Mesh box = test::boxBetween({0, 0, 0}, {1, 2, 3});
  const Point3 corner = box.vertices[5];
  const Point3* const where = box.vertices.data();
  const Mesh turned_box = turned(std::move(box), partFromLayers(plane(45, 90)));
  EXPECT_EQ(turned_box.vertices.data(), where);
  EXPECT_TRUE(turned_box.vertices[5].isApprox(partFromLayers(plane(45, 90)) * corner, kRounding));
  EXPECT_NEAR(volume(turned_box), 6.0, kRounding);
}

TEST(LayerPlane, TheFirstLayerIsHigherByTheCosineOfTheTilt) {
  // Straight above the lowest edge of a cube of 20 mm: 0.1 mm at 0, 30, 45 and 60 deg.
  const std::vector<std::pair<double, double>> cases = {
      {0.0, 0.1}, {30.0, 0.11547005}, {45.0, 0.14142136}, {60.0, 0.2}};
  for (const auto& [angle, vertical_mm] : cases) {
    const Eigen::Quaterniond part_from_layers = partFromLayers(plane(angle, 0));
    const Mesh cube = turned(test::boxBetween({0, 0, 0}, {20, 20, 20}), part_from_layers.conjugate());
    const Box3 box = boundingBox(cube);
    SlicingSettings settings;
    settings.first_layer_height_mm = 0.1;
    const LayerBounds first = stackLayers(box.low.z(), box.high.z(), settings).front();
    // The top plane of the layer is where normal . p is top_mm; over the edge (x, 20, 0) that is at this z.
    const Point3 normal = part_from_layers * Point3::UnitZ();
    const double z = (first.top_mm - normal.dot(Point3(7, 20, 0))) / normal.z();
    EXPECT_NEAR(z, vertical_mm, 1e-8) << angle;
  }
}

}  // namespace
}  // namespace lamina
