// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {

/// Meaning of a volume in the file of a part.
enum class VolumeKind : std::uint8_t {
  Modifier,         ///< region with settings of its own, not itself material
  Negative,         ///< region that is cut away
  SupportBlocker,   ///< region in which overhangs are not supported
  SupportEnforcer,  ///< region in which all overhangs are supported
  Object,           ///< box around a whole object that has settings
  Material,         ///< piece of the part with settings of its own
  Heights           ///< box over a range of heights of an object, with settings of its own
};

/// A volume that changes how the part within it is deposited.
struct MeshVolume {
  VolumeKind kind = VolumeKind::Modifier;
  Mesh mesh;
  std::vector<SettingText> settings = {};  ///< keys and values as the slicer has written them
  std::string of = {};  ///< name for messages, if it is an object or a range of its heights
};

/// One of the objects that a file distinguishes.
struct MeshObject {
  std::string name;  ///< empty if the file gives none
  Mesh mesh;
  std::vector<MeshVolume> volumes = {};  ///< volumes of the object besides its mesh
};

/// Reads the objects of a file: the items of a 3MF file's build list or the solids of a STEP file, each where
/// the file places it; in other formats one object, the file's mesh.
/// @throws as `readMesh`
std::vector<MeshObject> readMeshObjects(const std::string& path, const MeshUnits& units = {},
                                        const Tessellation& tessellation = {});

/// The same, with progress and cancellation as `readMesh`.
std::vector<MeshObject> readMeshObjects(const std::string& path, const MeshUnits& units,
                                        const Tessellation& tessellation, Progress& progress);

/// Reads the volumes of all objects of a file, which only 3MF files have. For each object, the volume of the
/// whole object comes first, then those of its pieces, those of ranges of heights, and those that are not
/// material of the object.
/// @throws as `readMesh`
std::vector<MeshVolume> readMeshVolumes(const std::string& path, const MeshUnits& units = {});

}  // namespace lamina
