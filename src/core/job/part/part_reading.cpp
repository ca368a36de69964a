// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/part/part_reading.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/edit_distance.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/extrusion.hpp"
#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"
#include "lamina/geometry/mesh_io/stated_unit.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/geometry/svg/svg_reader.hpp"

namespace lamina {

namespace {

/// The part that an outline becomes; the unit of meshes does not count, for an outline states its own.
Mesh extrudedOutline(const std::string& part, const InputSettings& settings) {
  if (settings.extrude_mm == 0.0)
    throw InvalidConfig("input.extrude_mm is 0 with the outline '" + part +
                        "'; expected the height of the part");
  Mesh mesh = extruded(readSvg(readTextFile(part), part), settings.extrude_mm);
  for (Point3& vertex : mesh.vertices) vertex.head<2>() *= settings.units.scale;
  return mesh;
}

constexpr const char* kUnit = "input.unit";

/// What is neither a file nor looks like the name of one is taken for a part.
void requireFileOrPart(const std::string& part) {
  const std::filesystem::path path(part);
  std::error_code unknown;
  if (path.has_extension() || path.has_parent_path() || std::filesystem::exists(path, unknown)) return;
  throw FileError("there is neither a file nor a part '" + part + "'" + suggestionFor(partNames(), part));
}

Mesh readOrMake(const std::string& part, const InputSettings& settings, Progress& progress) {
  if (!isPartName(part)) requireFileOrPart(part);
  requireUnitUnstated(part, settings.units.unit, kUnit);
  if (isSvgName(part)) return extrudedOutline(part, settings);
  if (!isPartName(part)) return readMesh(part, settings.units, settings.tessellation, progress);
  Mesh mesh = makePart(part);
  for (Point3& vertex : mesh.vertices) vertex *= settings.units.scale;
  return mesh;
}

SourcePart fitToSlice(Mesh mesh, RepairPolicy policy) {
  if (policy == RepairPolicy::Strict) requireSound(mesh);
  RepairResult repaired = repairMesh(std::move(mesh));
  SourcePart source;
  source.mesh = std::move(repaired.mesh);
  source.topology = std::move(repaired.topology);
  for (const RepairChange& change : repaired.changes) source.repairs.push_back(toText(change));
  return source;
}

}  // namespace

SourcePart readPart(const std::string& part, const InputSettings& settings, Progress& progress) {
  SourcePart source = fitToSlice(readOrMake(part, settings, progress), settings.repair);
  if (!isSvgName(part) && !isPartName(part)) source.volumes = readMeshVolumes(part, settings.units);
  return source;
}

std::vector<SourceObject> readParts(const std::string& part, const InputSettings& settings,
                                    Progress& progress) {
  std::vector<SourceObject> objects;
  if (isSvgName(part) || isPartName(part)) {
    objects.push_back({"", readPart(part, settings, progress)});
    return objects;
  }
  requireUnitUnstated(part, settings.units.unit, kUnit);
  for (MeshObject& object : readMeshObjects(part, settings.units, settings.tessellation, progress)) {
    objects.push_back({std::move(object.name), fitToSlice(std::move(object.mesh), settings.repair)});
    objects.back().source.volumes = std::move(object.volumes);
  }
  return objects;
}

}  // namespace lamina
