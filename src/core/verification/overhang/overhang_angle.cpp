// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/overhang_angle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "verification/overhang/deposited_walls.hpp"

namespace lamina {
namespace {

struct Facet {
  Point3 middle;
  Point3 normal;  // outward, of unit length
  double area_mm2 = 0.0;
};

Facet facetOf(const Mesh& mesh, const Triangle& corner) {
  const Point3& a = mesh.vertices[corner[0]];
  const Point3& b = mesh.vertices[corner[1]];
  const Point3& c = mesh.vertices[corner[2]];
  const Point3 cross = (b - a).cross(c - a);
  const double doubled = cross.norm();
  return {(a + b + c) / 3.0, doubled > 0.0 ? Point3(cross / doubled) : Point3(Point3::Zero()), 0.5 * doubled};
}

void addFacet(OverhangAngle& lean, const Facet& facet, const LayerGrowth& growth) {
  const double sine = std::min(1.0, -facet.normal.dot(growth.direction));
  if (sine <= 0.0) return;
  const double cosine = std::sqrt(1.0 - sine * sine);
  // Rounding leaves level undersides a cosine of some 1e-8.
  const double overhang =
      cosine > 1e-7 ? growth.bead.height_mm * sine / cosine : std::numeric_limits<double>::infinity();
  if (overhang > growth.bead.width_mm) lean.beyond_bead_mm2 += facet.area_mm2;
  const double angle = std::asin(sine);
  if (angle <= lean.greatest_rad) return;
  lean.greatest_rad = angle;
  lean.greatest_at = facet.middle;
  lean.overhang_mm = overhang;
}

double lowestAlong(const Mesh& mesh, const Point3& growth) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Point3& vertex : mesh.vertices) lowest = std::min(lowest, growth.dot(vertex));
  return lowest;
}

}  // namespace

OverhangAngle overhangAngle(const Mesh& mesh, const Point3& growth, const Bead& bead) {
  const double lowest = lowestAlong(mesh, growth);
  OverhangAngle lean;
  for (const Triangle& triangle : mesh.triangles) {
    const Facet facet = facetOf(mesh, triangle);
    lean.area_mm2 += facet.area_mm2;
    if (growth.dot(facet.middle) - lowest > 0.5 * bead.height_mm) addFacet(lean, facet, {growth, bead});
  }
  return lean;
}

OverhangAngle overhangAngle(const Mesh& mesh, const Toolpath& toolpath, double width_mm) {
  const DepositedWalls walls = depositedWalls(toolpath, width_mm);
  const NearestTriangle nearest(walls.motions);
  std::vector<std::uint32_t> motion(mesh.triangles.size());
  NoProgress nobody;
  parallelFor(
      motion.size(),
      [&](std::size_t i) { motion[i] = nearest.nearest(facetOf(mesh, mesh.triangles[i]).middle).triangle; },
      nobody, "overhang");
  const double on_bed = lowestAlong(mesh, Point3::UnitZ()) + 0.5 * walls.growth.front().bead.height_mm;
  OverhangAngle lean;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Facet facet = facetOf(mesh, mesh.triangles[i]);
    lean.area_mm2 += facet.area_mm2;
    if (motion[i] >= walls.in_first_layer && facet.middle.z() > on_bed)
      addFacet(lean, facet, walls.growth[motion[i]]);
  }
  return lean;
}

}  // namespace lamina
