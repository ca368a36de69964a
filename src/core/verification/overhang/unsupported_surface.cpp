// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/unsupported_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/subdivision.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "verification/overhang/deposited_walls.hpp"

namespace lamina {
namespace {

constexpr double kSamplesPerDiagonal = 100.0;
constexpr const char* kStage = "overhang";

/// @param growth_of  of a triangle by its number: unit vector; zero for one that rests
template <class GrowthOf>
UnsupportedSurface unsupportedBy(const Mesh& mesh, const SupportCriteria& question,
                                 const GrowthOf& growth_of) {
  const double limit = -std::sin(toRadians(question.max_overhang_deg)) - 1e-9;
  const double held_mm = boundingBox(mesh).low.z() + question.first_layer_mm;
  UnsupportedSurface surface;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& corner = mesh.triangles[i];
    const Point3& a = mesh.vertices[corner[0]];
    const Point3& b = mesh.vertices[corner[1]];
    const Point3& c = mesh.vertices[corner[2]];
    const Point3 cross = (b - a).cross(c - a);
    surface.surface_mm2 += 0.5 * cross.norm();
    if (std::max({a.z(), b.z(), c.z()}) <= held_mm) continue;
    if (cross.dot(growth_of(i)) >= limit * cross.norm()) continue;
    surface.unsupported_mm2 += 0.5 * cross.norm();
    const auto first = static_cast<std::uint32_t>(surface.region.vertices.size());
    surface.region.vertices.insert(surface.region.vertices.end(), {a, b, c});
    surface.region.triangles.push_back({first, first + 1, first + 2});
  }
  return surface;
}

}  // namespace

UnsupportedSurface unsupportedSurface(const Mesh& mesh, const Point3& growth,
                                      const SupportCriteria& question) {
  return unsupportedBy(mesh, question, [&](std::uint32_t) { return growth; });
}

UnsupportedSurface unsupportedSurface(const Mesh& mesh, const Toolpath& toolpath,
                                      const SupportCriteria& question, Progress& progress) {
  throwIfCancelled(progress, kStage);
  const DepositedWalls walls = depositedWalls(toolpath, 0.0);
  const NearestTriangle nearest(walls.motions);
  throwIfCancelled(progress, kStage);
  const Mesh fine = subdivide(mesh, boundingBox(mesh).size().norm() / kSamplesPerDiagonal).mesh;
  std::vector<Point3> growth(fine.triangles.size());
  parallelFor(
      growth.size(),
      [&](std::size_t i) {
        const Triangle& corner = fine.triangles[i];
        const Point3 middle =
            (fine.vertices[corner[0]] + fine.vertices[corner[1]] + fine.vertices[corner[2]]) / 3.0;
        const std::uint32_t motion = nearest.nearest(middle).triangle;
        growth[i] = motion < walls.in_first_layer ? Point3(Point3::Zero()) : walls.growth[motion].direction;
      },
      progress, kStage);
  return unsupportedBy(fine, question, [&](std::uint32_t i) { return growth[i]; });
}

}  // namespace lamina
