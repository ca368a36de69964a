// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/part/part_source.hpp"

#include <algorithm>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/extrusion.hpp"
#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/geometry/svg/svg_reader.hpp"

namespace lamina {

namespace {

/// The part that an outline becomes; the unit of meshes does not count, for an outline states its own.
Mesh extrudedOutline(const std::string& part, const InputSettings& settings) {
  if (settings.extrude_mm == 0.0)
    throw InvalidConfig("input.extrude_mm is 0 with the outline '" + part +
                        "'; expected the height of the part");
  Mesh mesh = extruded(readSvg(readFile(part), part), settings.extrude_mm);
  for (Point3& vertex : mesh.vertices) vertex.head<2>() *= settings.units.scale;
  return mesh;
}

Mesh readOrMake(const std::string& part, const InputSettings& settings) {
  if (isSvgName(part)) return extrudedOutline(part, settings);
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
