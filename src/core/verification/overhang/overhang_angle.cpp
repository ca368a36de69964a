// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/overhang_angle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"

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

/// What carries a facet: the way its layer grows, and how high and wide its bead is.
struct Growth {
  Point3 direction;
  Bead bead;
};

void addFacet(OverhangAngle& lean, const Facet& facet, const Growth& growth) {
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

/// The motions along which walls are deposited, in the order they are deposited, and how they grow.
struct DepositedWalls {
  Mesh motions;  // each one a triangle without width
  std::vector<Growth> growth;
  std::size_t in_first_layer = 0;
};

void addMotions(DepositedWalls& walls, const Path& path, double width_mm) {
  const auto first = static_cast<std::uint32_t>(walls.motions.vertices.size());
  walls.motions.vertices.insert(walls.motions.vertices.end(), path.points.begin(), path.points.end());
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    const auto from = static_cast<std::uint32_t>(first + m);
    const auto to = static_cast<std::uint32_t>(first + end);
    walls.motions.triangles.push_back({from, to, to});
    walls.growth.push_back(
        {-(path.orientation.at(end) * Point3::UnitZ()), {width_mm, path.bead.at(end).height_mm}});
  }
}

DepositedWalls depositedWalls(const Toolpath& toolpath, double width_mm) {
  const auto collect = [&](auto isWanted) {
    DepositedWalls walls;
    for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
      for (const Path& path : toolpath.layers[l].paths)
        if (isWanted(path.role)) addMotions(walls, path, width_mm);
      if (l == 0) walls.in_first_layer = walls.growth.size();
    }
    return walls;
  };
  DepositedWalls walls = collect([](PathRole role) { return role == PathRole::OuterWall; });
  if (walls.growth.empty())
    walls = collect(
        [](PathRole role) { return kindOf(role) == RoleKind::Wall || kindOf(role) == RoleKind::Infill; });
  if (walls.growth.empty()) throw InvalidInput("the toolpath deposits nothing; expected at least one bead");
  return walls;
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
