// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/steep_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lamina/slicing/unsliceable.hpp"

namespace lamina {
namespace {

constexpr double kFlat = 1e-6;           // mm within which a corner lies in the bottom or the top
constexpr double kSteepRounding = 1e-6;  // deg

bool isAt(const Mesh& mesh, const Triangle& corner, double z) {
  return std::all_of(corner.begin(), corner.end(),
                     [&](std::uint32_t v) { return std::abs(mesh.vertices[v].z() - z) <= kFlat; });
}

double leanDeg(const Mesh& mesh, const Triangle& corner) {
  const Point3& a = mesh.vertices[corner[0]];
  const Point3 normal = (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a);
  return std::atan2(std::abs(normal.z()), normal.head<2>().norm()) * 180.0 / M_PI;
}

}  // namespace

void requireNoSteepFaces(const Mesh& mesh, double max_lean_deg) {
  const Box3 box = boundingBox(mesh);
  Mesh steep;
  double greatest = 0.0;
  Point3 at = Point3::Zero();
  for (const Triangle& corner : mesh.triangles) {
    if (isAt(mesh, corner, box.low.z()) || isAt(mesh, corner, box.high.z())) continue;
    const double lean = leanDeg(mesh, corner);
    if (lean <= max_lean_deg + kSteepRounding) continue;
    steep.triangles.push_back(corner);
    if (lean <= greatest) continue;
    greatest = lean;
    at = (mesh.vertices[corner[0]] + mesh.vertices[corner[1]] + mesh.vertices[corner[2]]) / 3.0;
  }
  if (steep.triangles.empty()) return;
  steep.vertices = mesh.vertices;
  char message[256];
  std::snprintf(
      message, sizeof message,
      "%zu faces lean more from the vertical than adapted.max_lean_deg = %g deg, most by %.1f deg at "
      "(%.2f, %.2f, %.2f) mm; adapted layers need walls",
      steep.triangles.size(), max_lean_deg, greatest, at.x(), at.y(), at.z());
  throw Unsliceable(message, std::move(steep));
}

}  // namespace lamina
