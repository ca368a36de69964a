// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_bodies.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/boxes.hpp"
#include "geometry/mesh/six_volumes.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kUnseen = 0xFFFFFFFF;

/// The angle under which a triangle is seen [VanOosterom1983], positive from its inside.
double solidAngle(const Point3& a, const Point3& b, const Point3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double divisor = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2.0 * std::atan2(a.dot(b.cross(c)), divisor);
}

std::vector<Box3> bodyBoxesOf(const Mesh& mesh, const MeshBodies& bodies) {
  std::vector<Box3> boxes(bodies.volumes.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) boxes[bodies.body_of[t]].include(mesh.vertices[v]);
  return boxes;
}

/// In how many other bodies a point of this body lies.
int depthOf(std::uint32_t body, const Point3& point, const Mesh& mesh, const MeshBodies& bodies,
            const std::vector<Box3>& boxes) {
  std::vector<double> angles(boxes.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t other = bodies.body_of[t];
    if (other == body || !isInBox(boxes[other], point)) continue;
    const Triangle& triangle = mesh.triangles[t];
    angles[other] += solidAngle(mesh.vertices[triangle[0]] - point, mesh.vertices[triangle[1]] - point,
                                mesh.vertices[triangle[2]] - point);
  }
  int depth = 0;
  // A closed body is seen under 4 pi from its inside, whichever way it faces, and under 0 from outside.
  for (const double angle : angles) depth += std::abs(angle) > 2.0 * M_PI ? 1 : 0;
  return depth;
}

}  // namespace

MeshBodies findBodies(const Mesh& mesh, const MeshTopology& topology) {
  MeshBodies bodies;
  bodies.body_of.assign(mesh.triangles.size(), kUnseen);
  std::vector<std::uint32_t> waiting;
  const Point3 origin = mesh.triangles.empty() ? Point3(0, 0, 0) : mesh.vertices[mesh.triangles.front()[0]];
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (bodies.body_of[seed] != kUnseen) continue;
    const auto body = static_cast<std::uint32_t>(bodies.volumes.size());
    double six_volumes = 0.0;
    bodies.body_of[seed] = body;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const std::uint32_t triangle = waiting.back();
      waiting.pop_back();
      six_volumes += sixVolumes(mesh, mesh.triangles[triangle], origin);
      for (HalfEdge h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const HalfEdge opposite = topology.opposite[h];
        if (opposite == kNoHalfEdge || bodies.body_of[triangleOf(opposite)] != kUnseen) continue;
        bodies.body_of[triangleOf(opposite)] = body;
        waiting.push_back(triangleOf(opposite));
      }
    }
    bodies.volumes.push_back(six_volumes / 6.0);
  }
  return bodies;
}

std::vector<bool> findSheets(const Mesh& mesh, const MeshBodies& bodies) {
  // Rounding leaves about 1e-16 of area times distance; a real body has far more.
  constexpr double kNothing = 1e-12;
  const Point3 size = boundingBox(mesh).size();
  const double suspect = 1e-9 * size.squaredNorm() * size.norm();
  std::vector<bool> is_sheet(bodies.volumes.size(), false);
  bool has_suspect = false;
  for (const double volume : bodies.volumes) has_suspect |= std::abs(volume) <= suspect;
  if (!has_suspect) return is_sheet;
  std::vector<double> areas(bodies.volumes.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    const Point3& a = mesh.vertices[triangle[0]];
    areas[bodies.body_of[t]] +=
        0.5 * (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).norm();
  }
  for (std::size_t body = 0; body < areas.size(); ++body)
    is_sheet[body] = std::abs(bodies.volumes[body]) <= kNothing * areas[body] * size.norm();
  return is_sheet;
}

std::vector<bool> findInwardBodies(const Mesh& mesh, const MeshBodies& bodies) {
  std::vector<bool> is_inward(bodies.volumes.size(), false);
  bool has_negative = false;
  for (const double volume : bodies.volumes) has_negative |= volume < 0.0;
  if (!has_negative) return is_inward;
  const std::vector<Box3> boxes = bodyBoxesOf(mesh, bodies);
  std::vector<bool> is_seen(bodies.volumes.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t body = bodies.body_of[t];
    if (is_seen[body]) continue;
    is_seen[body] = true;
    if (bodies.volumes[body] >= 0.0) continue;
    const Point3& point = mesh.vertices[mesh.triangles[t][0]];
    is_inward[body] = depthOf(body, point, mesh, bodies, boxes) % 2 == 0;
  }
  return is_inward;
}

}  // namespace lamina
