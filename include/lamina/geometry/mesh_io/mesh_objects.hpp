// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {

/// What a volume of an object is.
enum class VolumeKind : std::uint8_t {
  Modifier,         ///< no part of the part, with settings of its own
  Negative,         ///< cut away
  SupportBlocker,   ///< where nothing is held up
  SupportEnforcer,  ///< where all that hangs is held up
  Object,           ///< a box round a whole object that has settings
  Material,         ///< a piece of the part, with settings of its own
  Heights           ///< a box from height to height of an object, with settings of its own
};

/// A volume that says how the part within it is deposited.
struct MeshVolume {
  VolumeKind kind = VolumeKind::Modifier;
  Mesh mesh;
  std::vector<SettingText> settings = {};  ///< by the names and in the words of the slicer that wrote them
  std::string of = {};                     ///< for messages: the object or its heights, if that is what it is
};

/// One of the objects that a file distinguishes.
struct MeshObject {
  std::string name;  ///< empty if the file gives none
  Mesh mesh;
  std::vector<MeshVolume> volumes = {};  ///< besides
};

/// The items of a 3MF file's build list, the solids of a STEP file, each where the file places it; of other
/// formats one object, the file's mesh.
/// @throws as `readMesh`
std::vector<MeshObject> readMeshObjects(const std::string& path, const MeshUnits& units = {},
                                        const Tessellation& tessellation = {});

/// The same, reported and cancelled as `readMesh` is.
std::vector<MeshObject> readMeshObjects(const std::string& path, const MeshUnits& units,
                                        const Tessellation& tessellation, Progress& progress);

/// The volumes of all objects of a file that say how the part is deposited, which only 3MF files have. For
/// each object, volumes of the whole object come first. Those of its pieces follow, those of heights, and
/// those that are no part of the object.
/// @throws as `readMesh`
std::vector<MeshVolume> readMeshVolumes(const std::string& path, const MeshUnits& units = {});

}  // namespace lamina
