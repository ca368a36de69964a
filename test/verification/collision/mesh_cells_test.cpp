// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/mesh_cells.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

/// A trough of 100 x 60 x 40 mm, open above, whose walls and floor are 10 mm thick.
Mesh trough() {
  const std::array<Point2, 8> outline = {Point2(-30, 0), Point2(30, 0),   Point2(30, 40),  Point2(20, 40),
                                         Point2(20, 10), Point2(-20, 10), Point2(-20, 40), Point2(-30, 40)};
  Mesh mesh;
  for (const double x : {-50.0, 50.0})
    for (const Point2& corner : outline) mesh.vertices.emplace_back(x, corner.x(), corner.y());
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t next = (i + 1) % 8;
    mesh.triangles.push_back({i, next + 8, next});
    mesh.triangles.push_back({i, i + 8, next + 8});
  }
  for (const Triangle& t : {Triangle{0, 1, 4}, Triangle{0, 4, 5}, Triangle{1, 2, 3}, Triangle{1, 3, 4},
                            Triangle{0, 5, 6}, Triangle{0, 6, 7}}) {
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  }
  return mesh;
}

bool isInTrough(const Point3& point) {
  const bool is_in_box =
      std::abs(point.x()) < 50.0 && std::abs(point.y()) < 30.0 && point.z() > 0.0 && point.z() < 40.0;
  return is_in_box && !(std::abs(point.y()) < 20.0 && point.z() > 10.0);
}

Point3 pointAbout(Random& random) {
  return {random.uniform(-60.0, 60.0), random.uniform(-40.0, 40.0), random.uniform(-10.0, 50.0)};
}

TEST(MeshCells, FindTheSideOfAPoint) {
  const Mesh mesh = trough();
  const MeshCells cells(mesh);
  Random random(7);
  int within = 0;
  for (int i = 0; i < 5000; ++i) {
    const Point3 point = pointAbout(random);
    EXPECT_EQ(cells.isWithin(point), isInTrough(point)) << point.transpose();
    within += isInTrough(point) ? 1 : 0;
  }
  EXPECT_GT(within, 500);
}

TEST(MeshCells, DecideAsTheSolidAngleDoesWhereTrianglesAreMissing) {
  Mesh mesh = trough();
  mesh.triangles.erase(mesh.triangles.begin() + 4, mesh.triangles.begin() + 7);
  const MeshCells cells(mesh);
  const SolidAngle angle(mesh);
  Random random(8);
  for (int i = 0; i < 5000; ++i) {
    const Point3 point = pointAbout(random);
    const bool is_in_box =
        std::abs(point.x()) <= 50.0 && std::abs(point.y()) <= 30.0 && std::abs(point.z() - 20.0) <= 20.0;
    EXPECT_EQ(cells.isWithin(point), is_in_box && angle.isWithin(point)) << point.transpose();
  }
}

TEST(MeshCells, ABoxThatIsFarMeetsNoTriangle) {
  const Mesh mesh = trough();
  const MeshCells cells(mesh);
  Random random(9);
  for (int i = 0; i < 5000; ++i) {
    const Triangle& corners = mesh.triangles[random.below(mesh.triangles.size())];
    const double a = random.uniform(0.0, 1.0);
    const double b = random.uniform(0.0, 1.0 - a);
    const Point3 on_it = a * mesh.vertices[corners[0]] + b * mesh.vertices[corners[1]] +
                         (1.0 - a - b) * mesh.vertices[corners[2]];
    const Point3 size(random.uniform(0.0, 20.0), random.uniform(0.0, 20.0), random.uniform(0.0, 20.0));
    const Point3 low = on_it - random.uniform(0.0, 1.0) * size;
    EXPECT_FALSE(cells.isFarFrom({low, low + size})) << on_it.transpose();
  }
}

TEST(MeshCells, BoxesInTheTroughWithinAWallAndBesideAreFar) {
  const Mesh mesh = trough();
  const MeshCells cells(mesh);
  EXPECT_TRUE(cells.isFarFrom({Point3(-5, -10, 15), Point3(5, 10, 60)}));
  EXPECT_TRUE(cells.isFarFrom({Point3(-10, -27, 10), Point3(10, -23, 35)}));
  EXPECT_TRUE(cells.isFarFrom({Point3(-40, 33, 10), Point3(40, 40, 35)}));
  EXPECT_TRUE(MeshCells(Mesh()).isFarFrom({Point3(-1, -1, -1), Point3(1, 1, 1)}));
  EXPECT_FALSE(MeshCells(Mesh()).isWithin(Point3::Zero()));
}

}  // namespace
}  // namespace lamina
