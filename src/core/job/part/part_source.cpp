// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/part/part_source.hpp"

#include <algorithm>

#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/geometry/parts/parts.hpp"

namespace lamina {

namespace {

Mesh readOrMake(const std::string& part, const InputSettings& settings) {
  const std::vector<std::string> names = partNames();
  if (std::find(names.begin(), names.end(), part) == names.end()) return readMesh(part, settings.units);
  Mesh mesh = makePart(part);
  for (Point3& vertex : mesh.vertices) vertex *= settings.units.scale;
  return mesh;
}

}  // namespace

SourcePart readPart(const std::string& part, const InputSettings& settings) {
  Mesh mesh = readOrMake(part, settings);
  if (settings.repair == RepairPolicy::Strict) requireSound(mesh);
  RepairResult repaired = repairMesh(std::move(mesh));
  SourcePart source = {
      std::move(repaired.mesh), std::move(repaired.topology), {}, Eigen::Affine3d::Identity(), {}};
  for (const RepairChange& change : repaired.changes) source.repairs.push_back(toText(change));
  return source;
}

}  // namespace lamina
