// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/mesh_repair.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "geometry/mesh/mesh_bodies.hpp"
#include "geometry/mesh/repair/steps.hpp"
#include "geometry/mesh/six_volumes.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::string toText(const Point3& point) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g) mm", point.x(), point.y(), point.z());
  return text;
}

std::string at(const std::string& what, const Point3& where) { return what + " at " + toText(where); }

std::optional<std::string> findBorder(const Mesh& mesh, const MeshTopology& topology) {
  if (!topology.has_border) return std::nullopt;
  for (HalfEdge h = 0; h < topology.opposite.size(); ++h) {
    const std::uint32_t from = originOf(mesh, h);
    const std::uint32_t to = originOf(mesh, nextInTriangle(h));
    if (topology.opposite[h] != kNoHalfEdge || from == to) continue;
    return at("not closed: nothing fits the triangle's edge",
              0.5 * (mesh.vertices[from] + mesh.vertices[to]));
  }
  return std::nullopt;
}

std::optional<std::string> findBody(const Mesh& mesh, const MeshBodies& bodies,
                                    const std::vector<bool>& is_wanted, const char* what) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (is_wanted[bodies.body_of[t]]) return at(what, middleOf(mesh, mesh.triangles[t]));
  return std::nullopt;
}

/// The first defect of a mesh without degenerate triangles, and where it is.
std::optional<std::string> findDefect(const Mesh& mesh, const MeshTopology& topology) {
  if (mesh.triangles.empty()) return "no triangles";
  if (auto border = findBorder(mesh, topology)) return border;
  const MeshBodies bodies = findBodies(mesh, topology);
  if (auto sheet = findBody(mesh, bodies, findSheets(mesh, bodies), "a body without volume")) return sheet;
  return findBody(mesh, bodies, findInwardBodies(mesh, bodies), "a body that faces inwards");
}

/// Leaves out the vertices that no triangle uses any more.
void compact(Mesh& mesh) {
  constexpr std::uint32_t kUnused = 0xFFFFFFFF;
  std::vector<std::uint32_t> moved(mesh.vertices.size(), kUnused);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) moved[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < moved.size(); ++v) {
    if (moved[v] == kUnused) continue;
    mesh.vertices[kept] = mesh.vertices[v];
    moved[v] = kept++;
  }
  mesh.vertices.resize(kept);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = moved[v];
}

/// The mesh on its way through the steps, with its topology.
class Repair {
 public:
  explicit Repair(Mesh mesh) {
    RepairStep clean = dropDegenerateTriangles(std::move(mesh));
    mesh_ = std::move(clean.mesh);
    changes_ = std::move(clean.changes);
    topology_ = pairHalfEdges(mesh_);
  }

  void rebuild(double tolerance) {
    apply(dropRepeatedTriangles(std::move(mesh_), topology_));
    apply(dropBackOfDoubledSurface(std::move(mesh_)));
    const Point3 middle = boundingBox(mesh_).centre();
    // Of a surface with cracks it is nearly what it encloses, seen from its middle.
    const double given_mm3 = std::abs(volumeFrom(middle, mesh_));
    apply(stitchBorders(std::move(mesh_), topology_, tolerance));
    apply(splitAtBorderVertices(std::move(mesh_), topology_, tolerance));
    apply(dropDegenerateTriangles(std::move(mesh_)));
    apply(dropRepeatedTriangles(std::move(mesh_), topology_));
    apply(orientConsistently(std::move(mesh_), topology_));
    const std::size_t unfilled = changes_.size();
    apply(fillHoles(std::move(mesh_), topology_));
    const std::size_t holes = changes_.size() - unfilled;
    apply(turnOutwards(std::move(mesh_), topology_));
    compact(mesh_);
    if (holes > kFewHoles && !mesh_.triangles.empty())
      reportLoss(1.0 - std::abs(volumeFrom(middle, mesh_)) / given_mm3, middle);
  }

  std::optional<std::string> defect() const { return findDefect(mesh_, topology_); }
  const Mesh& mesh() const { return mesh_; }
  RepairResult result() && { return {std::move(mesh_), std::move(topology_), std::move(changes_)}; }

 private:
  static constexpr std::size_t kFewHoles = 3;

  /// Pieces of a torn surface close to slivers or to nothing, of which no single change tells.
  /// @param share  of the volume; below 0, or no number, where nothing was enclosed
  void reportLoss(double share, const Point3& middle) {
    constexpr double kGreat = 0.1;
    if (!(share > kGreat)) return;
    const auto percent = static_cast<std::size_t>(std::lround(100.0 * share));
    changes_.push_back({"% of the enclosed volume lost with torn pieces", percent, middle});
  }

  void apply(RepairStep step) {
    mesh_ = std::move(step.mesh);
    if (!step.changes.empty()) topology_ = pairHalfEdges(mesh_);
    changes_.insert(changes_.end(), step.changes.begin(), step.changes.end());
  }

  Mesh mesh_;
  MeshTopology topology_;
  std::vector<RepairChange> changes_;
};

std::string noneLeft(std::size_t given, const std::vector<RepairChange>& changes) {
  std::string text = "the mesh encloses nothing: of " + std::to_string(given) + " triangles none is left";
  for (const RepairChange& change : changes) text += ", " + toText(change);
  return text + "; expected faces around a volume";
}

}  // namespace

std::string toText(const RepairChange& change) {
  return std::to_string(change.count) + " " + change.what + " near " + toText(change.where);
}

RepairResult repairMesh(Mesh mesh, const RepairSettings& settings) {
  const std::size_t given = mesh.triangles.size();
  Repair repair(std::move(mesh));
  if (!repair.defect()) return std::move(repair).result();
  repair.rebuild(std::min(settings.stitch_tolerance_mm, 1e-4 * boundingBox(repair.mesh()).size().norm()));
  if (repair.mesh().triangles.empty()) throw InvalidMesh(noneLeft(given, std::move(repair).result().changes));
  if (const auto defect = repair.defect()) throw InvalidMesh("the mesh cannot be repaired: " + *defect);
  return std::move(repair).result();
}

void requireSound(const Mesh& mesh) {
  const RepairStep degenerate = dropDegenerateTriangles(mesh);
  if (!degenerate.changes.empty())
    throw InvalidMesh("the mesh is not sound: a degenerate triangle at " +
                      toText(degenerate.changes[0].where));
  if (const auto defect = findDefect(mesh, pairHalfEdges(mesh)))
    throw InvalidMesh("the mesh is not sound: " + *defect);
}

}  // namespace lamina
