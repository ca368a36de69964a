// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/plane_chart.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace lamina {
namespace {

// Vertices may lie off the plane by this share of the surface's size, which changes lengths by its square.
constexpr double kFlatness = 1e-6;

Point3 areaVector(const Mesh& surface, const Triangle& corner) {
  const Point3& a = surface.vertices[corner[0]];
  return (surface.vertices[corner[1]] - a).cross(surface.vertices[corner[2]] - a);
}

bool isPlane(const Mesh& surface, const Point3& normal) {
  const Box3 box = boundingBox(surface);
  const double reach = kFlatness * box.size().norm();
  const double level = normal.dot(surface.vertices[surface.triangles[0][0]]);
  for (const Triangle& corner : surface.triangles) {
    for (const std::uint32_t vertex : corner)
      if (std::abs(normal.dot(surface.vertices[vertex]) - level) > reach) return false;
    if (normal.dot(areaVector(surface, corner)) < 0.0) return false;
  }
  return true;
}

}  // namespace

std::optional<std::vector<Point2>> planeParameterization(const Mesh& surface) {
  Point3 sum = Point3::Zero();
  for (const Triangle& corner : surface.triangles) sum += areaVector(surface, corner);
  if (!(sum.norm() > 0.0)) return std::nullopt;
  const Point3 normal = sum.normalized();
  if (!isPlane(surface, normal)) return std::nullopt;
  const bool is_level = std::hypot(normal.x(), normal.y()) <= kFlatness && normal.z() > 0.0;
  const Eigen::Matrix3d turn =
      is_level ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
               : Eigen::Quaterniond::FromTwoVectors(normal, Point3::UnitZ()).toRotationMatrix();
  std::vector<Point2> plan;
  plan.reserve(surface.vertices.size());
  for (const Point3& vertex : surface.vertices) plan.emplace_back((turn * vertex).head<2>());
  return plan;
}

}  // namespace lamina
