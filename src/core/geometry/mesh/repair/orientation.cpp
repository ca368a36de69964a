// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "geometry/mesh/mesh_bodies.hpp"
#include "geometry/mesh/repair/steps.hpp"

namespace lamina {
namespace {

enum class Turn : std::uint8_t { Unseen, Kept, Turned };

/// A single half-edge by the edge it belongs to.
struct Single {
  std::uint64_t edge;
  HalfEdge half_edge;
};

/// Per half-edge, another single one that runs the same way along the same edge, or none: the neighbour is
/// oriented against this triangle. Where several do, they are taken two by two.
std::vector<HalfEdge> findContrary(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<Single> singles;
  for (HalfEdge h = 0; h < topology.opposite.size(); ++h) {
    if (topology.opposite[h] != kNoHalfEdge) continue;
    const std::uint64_t from = originOf(mesh, h);
    const std::uint64_t to = originOf(mesh, nextInTriangle(h));
    singles.push_back({from < to ? from << 32 | to : to << 32 | from, h});
  }
  std::sort(singles.begin(), singles.end(), [](const Single& a, const Single& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.half_edge < b.half_edge;
  });
  std::vector<HalfEdge> contrary(topology.opposite.size(), kNoHalfEdge);
  for (std::size_t i = 0; i + 1 < singles.size(); ++i) {
    if (singles[i].edge != singles[i + 1].edge) continue;
    contrary[singles[i].half_edge] = singles[i + 1].half_edge;
    contrary[singles[i + 1].half_edge] = singles[i].half_edge;
    ++i;
  }
  return contrary;
}

class Orienter {
 public:
  Orienter(const Mesh& mesh, const MeshTopology& topology)
      : topology_(topology), contrary_(findContrary(mesh, topology_)), turns_(mesh.triangles.size()) {}

  /// The triangles to turn: of each connected patch the fewer.
  std::vector<std::uint32_t> findTurned() {
    std::vector<std::uint32_t> turned;
    for (std::uint32_t seed = 0; seed < turns_.size(); ++seed) {
      if (turns_[seed] != Turn::Unseen) continue;
      spreadFrom(seed);
      const auto is_turned = [this](std::uint32_t t) { return turns_[t] == Turn::Turned; };
      const auto count = std::count_if(patch_.begin(), patch_.end(), is_turned);
      const Turn fewer = 2 * static_cast<std::size_t>(count) > patch_.size() ? Turn::Kept : Turn::Turned;
      for (const std::uint32_t t : patch_)
        if (turns_[t] == fewer) turned.push_back(t);
    }
    std::sort(turned.begin(), turned.end());
    return turned;
  }

 private:
  void spreadFrom(std::uint32_t seed) {
    patch_.assign(1, seed);
    turns_[seed] = Turn::Kept;
    for (std::size_t i = 0; i < patch_.size(); ++i) {
      const std::uint32_t triangle = patch_[i];
      const Turn same = turns_[triangle];
      const Turn other = same == Turn::Kept ? Turn::Turned : Turn::Kept;
      for (HalfEdge h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        reach(topology_.opposite[h], same);
        reach(contrary_[h], other);
      }
    }
  }

  void reach(HalfEdge half_edge, Turn turn) {
    if (half_edge == kNoHalfEdge || turns_[triangleOf(half_edge)] != Turn::Unseen) return;
    turns_[triangleOf(half_edge)] = turn;
    patch_.push_back(triangleOf(half_edge));
  }

  const MeshTopology& topology_;
  std::vector<HalfEdge> contrary_;
  std::vector<Turn> turns_;
  std::vector<std::uint32_t> patch_;
};

void turn(Mesh& mesh, std::uint32_t triangle) {
  std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

/// Turns whole bodies, and reports bodies, not triangles.
void turnBodies(RepairStep& step, const MeshBodies& bodies, const std::vector<bool>& is_turned) {
  RepairChange change = {"bodies turned outwards", 0, {}};
  std::vector<bool> is_counted(is_turned.size(), false);
  for (std::uint32_t t = 0; t < step.mesh.triangles.size(); ++t) {
    const std::uint32_t body = bodies.body_of[t];
    if (!is_turned[body]) continue;
    if (change.count == 0) change.where = middleOf(step.mesh, step.mesh.triangles[t]);
    if (!is_counted[body]) ++change.count;
    is_counted[body] = true;
    turn(step.mesh, t);
  }
  if (change.count > 0) step.changes.push_back(change);
}

/// Drops the triangles of bodies without volume; `bodies` are those of the mesh before and after.
void dropSheets(RepairStep& step, MeshBodies& bodies) {
  Mesh& mesh = step.mesh;
  const std::vector<bool> is_sheet = findSheets(mesh, bodies);
  RepairChange change = {"triangles of bodies without volume dropped", 0, {}};
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_sheet[bodies.body_of[t]]) {
      mesh.triangles[kept++] = mesh.triangles[t];
    } else if (change.count++ == 0) {
      change.where = middleOf(mesh, mesh.triangles[t]);
    }
  }
  if (change.count == 0) return;
  mesh.triangles.resize(kept);
  step.changes.push_back(change);
  bodies = findBodies(mesh, pairHalfEdges(mesh));
}

}  // namespace

RepairStep orientConsistently(Mesh mesh, const MeshTopology& topology) {
  const std::vector<std::uint32_t> turned = Orienter(mesh, topology).findTurned();
  if (turned.empty()) return {std::move(mesh), {}};
  const RepairChange change = {"triangles turned to agree with their neighbours", turned.size(),
                               middleOf(mesh, mesh.triangles[turned.front()])};
  for (const std::uint32_t t : turned) turn(mesh, t);
  return {std::move(mesh), {change}};
}

RepairStep turnOutwards(Mesh mesh, const MeshTopology& topology) {
  RepairStep step = {std::move(mesh), {}};
  MeshBodies bodies = findBodies(step.mesh, topology);
  dropSheets(step, bodies);
  double total = 0.0;
  for (const double body_volume : bodies.volumes) total += body_volume;
  // A part that is inside out as a whole takes its cavities along.
  std::vector<bool> is_turned(bodies.volumes.size(), total < 0.0);
  if (total < 0.0) {
    turnBodies(step, bodies, is_turned);
    for (double& body_volume : bodies.volumes) body_volume = -body_volume;
  }
  turnBodies(step, bodies, findInwardBodies(step.mesh, bodies));
  return step;
}

}  // namespace lamina
