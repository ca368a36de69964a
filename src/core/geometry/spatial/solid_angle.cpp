// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/spatial/solid_angle.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace lamina {
namespace {

constexpr std::uint32_t kTogether = 4;      // triangles of a leaf
constexpr double kFarRadii = 2.5;           // from where triangles count as one area
constexpr double kHalf = 2.0 * M_PI;        // sr
constexpr double kUndecided = 0.25 * M_PI;  // sr about the half; areas err by some hundredths

}  // namespace

SolidAngle::SolidAngle(const Mesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
  if (mesh.triangles.empty()) return;
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Point3> middles;
  middles.reserve(mesh.triangles.size());
  for (const Triangle& corner : mesh.triangles)
    middles.push_back(mesh.vertices[corner[0]] + mesh.vertices[corner[1]] + mesh.vertices[corner[2]]);
  nodes_.reserve(mesh.triangles.size());
  build(0, static_cast<std::uint32_t>(order_.size()), middles);
}

SolidAngle::Node SolidAngle::nodeOf(std::uint32_t first, std::uint32_t last) const {
  Node node;
  double weight = 0.0;
  for (std::uint32_t i = first; i < last; ++i) {
    const Triangle& corner = mesh_.triangles[order_[i]];
    const Point3& a = mesh_.vertices[corner[0]];
    const Point3 area = 0.5 * (mesh_.vertices[corner[1]] - a).cross(mesh_.vertices[corner[2]] - a);
    node.area += area;
    node.middle += area.norm() / 3.0 * (a + mesh_.vertices[corner[1]] + mesh_.vertices[corner[2]]);
    weight += area.norm();
  }
  node.middle =
      weight > 0.0 ? Point3(node.middle / weight) : mesh_.vertices[mesh_.triangles[order_[first]][0]];
  for (std::uint32_t i = first; i < last; ++i)
    for (const std::uint32_t corner : mesh_.triangles[order_[i]])
      node.radius_mm = std::max(node.radius_mm, (mesh_.vertices[corner] - node.middle).norm());
  return node;
}

std::uint32_t SolidAngle::build(std::uint32_t first, std::uint32_t last, const std::vector<Point3>& middles) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(nodeOf(first, last));
  if (last - first <= kTogether) {
    nodes_[number].first = first;
    nodes_[number].count = last - first;
    return number;
  }
  Box3 spread;
  for (std::uint32_t i = first; i < last; ++i) spread.include(middles[order_[i]]);
  Eigen::Index axis = 0;
  spread.size().maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double left = middles[a][axis];
                     const double right = middles[b][axis];
                     return left != right ? left < right : a < b;
                   });
  build(first, middle, middles);
  const std::uint32_t right = build(middle, last, middles);
  nodes_[number].first = right;
  return number;
}

/// [VanOosterom1983].
double SolidAngle::ofTriangle(std::uint32_t triangle, const Point3& point) const {
  const Triangle& corner = mesh_.triangles[triangle];
  const Point3 a = mesh_.vertices[corner[0]] - point;
  const Point3 b = mesh_.vertices[corner[1]] - point;
  const Point3 c = mesh_.vertices[corner[2]] - point;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double SolidAngle::roughAt(std::uint32_t number, const Point3& point) const {
  const Node& node = nodes_[number];
  const Point3 away = node.middle - point;
  const double squared = away.squaredNorm();
  const double far_mm = kFarRadii * node.radius_mm;
  if (squared > far_mm * far_mm) return node.area.dot(away) / (squared * std::sqrt(squared));
  if (node.count == 0) return roughAt(number + 1, point) + roughAt(node.first, point);
  double angle = 0.0;
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) angle += ofTriangle(order_[i], point);
  return angle;
}

double SolidAngle::exactAt(const Point3& point) const {
  double angle = 0.0;
  for (std::uint32_t triangle = 0; triangle < mesh_.triangles.size(); ++triangle)
    angle += ofTriangle(triangle, point);
  return angle;
}

bool SolidAngle::isWithin(const Point3& point) const {
  if (nodes_.empty()) return false;
  const double rough = std::abs(roughAt(0, point));
  const double angle = std::abs(rough - kHalf) > kUndecided ? rough : std::abs(exactAt(point));
  return angle > kHalf;
}

}  // namespace lamina
