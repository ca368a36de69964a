// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/limb_ends.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "geometry/mesh/area_vector.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {
namespace {

constexpr double kLimbCells = 3.0;
constexpr double kSlanting = 0.65;  // of the side of its square, how far an end reaches along the limb
constexpr double kFacingRad = toRadians(60.0);

/// Length along a limb, from its end, over which it becomes less deep by that much.
double lengthFor(double depth_mm2) { return std::sqrt(2.0 * std::max(0.0, depth_mm2)); }

/// A connected piece of the surface.
struct Face {
  std::vector<std::uint32_t> triangles;
  double area_mm2 = 0.0;
  double depth_mm2 = 0.0;  // on average
  double flatness = 1.0;   // of a flat one 1, of half a sphere 0.5
};

class LimbEnds {
 public:
  explicit LimbEnds(const LimbQuestion& question)
      : question_(question),
        topology_(pairHalfEdges(question.mesh)),
        depth_sum_(question.mesh.triangles.size(), 0.0),
        parts_(question.mesh.triangles.size(), 0.0),
        seen_(question.mesh.triangles.size(), 0) {
    for (const SkinPart& part : question_.skin) {
      if (!isReached(part.node)) continue;
      const auto [first, last] = partsAt(question_.skin, part.node);
      const double share = 1.0 / static_cast<double>(last - first);
      depth_sum_[part.triangle] += share * question_.depth_mm2[part.node];
      parts_[part.triangle] += share;
    }
  }

  std::vector<Point3> find() {
    std::vector<char> is_end(question_.mesh.triangles.size(), 0);
    for (const std::uint32_t node : deepestNodes())
      for (const std::uint32_t triangle : endAt(node).triangles) is_end[triangle] = 1;
    std::vector<Point3> ends(question_.cells.nodeCount(), Point3::Zero());
    for (const SkinPart& part : question_.skin)
      if (is_end[part.triangle] != 0 && isReached(part.node)) ends[part.node] = part.normal;
    return ends;
  }

 private:
  bool isReached(std::uint32_t node) const { return question_.depth_mm2[node] >= 0.0; }
  double limbLength() const { return kLimbCells * question_.cells.frame().voxel_mm; }

  /// Of each limb; by depth from the deepest on, limbs meet where nodes join them.
  std::vector<std::uint32_t> deepestNodes() const {
    const std::vector<double>& depth = question_.depth_mm2;
    const std::vector<std::uint32_t> order = nodesByDepth();
    std::vector<std::uint32_t> towards(question_.cells.nodeCount(), CellGraph::kNone);
    const auto deepestOf = [&](std::uint32_t node) {
      while (towards[node] != node) node = towards[node] = towards[towards[node]];
      return node;
    };
    std::vector<char> is_limb(question_.cells.nodeCount(), 0);
    for (const std::uint32_t node : order) {
      towards[node] = node;
      is_limb[node] = 1;
      for (const std::uint32_t near : question_.cells.links(node)) {
        if (towards[near] == CellGraph::kNone) continue;
        std::uint32_t limb = deepestOf(near);
        std::uint32_t own = deepestOf(node);
        if (limb == own) continue;
        if (depth[limb] < depth[own] || (depth[limb] == depth[own] && limb > own)) std::swap(limb, own);
        towards[own] = limb;
        if (lengthFor(depth[own] - depth[node]) < limbLength()) is_limb[own] = 0;
      }
    }
    std::vector<std::uint32_t> deepest;
    for (const std::uint32_t node : order)
      if (is_limb[node] != 0) deepest.push_back(node);
    return deepest;
  }

  std::vector<std::uint32_t> nodesByDepth() const {
    std::vector<std::uint32_t> order;
    order.reserve(question_.cells.nodeCount());
    for (std::uint32_t node = 0; node < question_.cells.nodeCount(); ++node)
      if (isReached(node)) order.push_back(node);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return question_.depth_mm2[a] > question_.depth_mm2[b];
    });
    return order;
  }

  Face endAt(std::uint32_t node) {
    std::vector<Face> faces = facesAt(node);
    if (faces.empty()) return {};
    const auto lengthOf = [&](const Face& face) {
      return lengthFor(question_.depth_mm2[node] - face.depth_mm2);
    };
    // The outer side of a sharp bend is nearly as deep as the end, but not flat.
    const auto scoreOf = [&](const Face& face) { return lengthOf(face) / (face.flatness * face.flatness); };
    const double cell = question_.cells.frame().voxel_mm;
    std::size_t best = faces.size();
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (faces[i].area_mm2 >= cell * cell &&
          (best == faces.size() || scoreOf(faces[i]) < scoreOf(faces[best])))
        best = i;
    if (best == faces.size()) return {};
    if (lengthOf(faces[best]) > kSlanting * std::sqrt(faces[best].area_mm2)) return {};
    return std::move(faces[best]);
  }

  /// At a node and beside it.
  std::vector<Face> facesAt(std::uint32_t node) {
    std::vector<std::uint32_t> triangles;
    const auto look = [&](std::uint32_t at) {
      const auto [first, last] = partsAt(question_.skin, at);
      for (const SkinPart* part = first; part != last; ++part)
        if (parts_[part->triangle] > 0.0) triangles.push_back(part->triangle);
    };
    look(node);
    for (const std::uint32_t near : question_.cells.links(node)) look(near);
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::vector<Face> faces;
    faces.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles) faces.push_back(faceFrom(triangle));
    return faces;
  }

  /// What faces as a triangle does and is connected to it.
  Face faceFrom(std::uint32_t start) {
    const Mesh& mesh = question_.mesh;
    const Point3 normal = triangleNormal(mesh, start);
    Face face;
    face.triangles.assign(1, start);
    ++round_;
    seen_[start] = round_;
    for (std::size_t i = 0; i < face.triangles.size(); ++i) {
      const std::uint32_t triangle = face.triangles[i];
      for (HalfEdge side = 3 * triangle; side < 3 * triangle + 3; ++side) {
        if (topology_.opposite[side] == kNoHalfEdge) continue;
        const std::uint32_t next = triangleOf(topology_.opposite[side]);
        if (seen_[next] == round_ || triangleNormal(mesh, next).dot(normal) < std::cos(kFacingRad)) continue;
        seen_[next] = round_;
        face.triangles.push_back(next);
      }
    }
    double parts = 0.0;
    Point3 sum = Point3::Zero();
    for (const std::uint32_t triangle : face.triangles) {
      face.area_mm2 += triangleArea(mesh, triangle);
      sum += areaVector(mesh, mesh.triangles[triangle]);
      face.depth_mm2 += depth_sum_[triangle];
      parts += parts_[triangle];
    }
    face.depth_mm2 /= parts;
    face.flatness = 0.5 * sum.norm() / face.area_mm2;
    return face;
  }

  const LimbQuestion& question_;
  MeshTopology topology_;
  std::vector<double> depth_sum_;    // by triangles, of their parts
  std::vector<double> parts_;        // by triangles, shares in nodes
  std::vector<std::uint32_t> seen_;  // by triangles, in which face last
  std::uint32_t round_ = 0;
};

}  // namespace

std::vector<Point3> limbEnds(const LimbQuestion& question) { return LimbEnds(question).find(); }

}  // namespace lamina
