// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// Effect of a modifier in its region.
enum class ModifierKind : std::uint8_t {
  Settings,         ///< other settings hold in the region
  Negative,         ///< the part has no material in the region
  SupportBlocker,   ///< overhangs in the region are not supported
  SupportEnforcer,  ///< all overhangs in the region are supported
  SeamHere          ///< walls that pass through the region start in it
};

/// A region of a part in which something differs: a mesh, a box or a range of heights.
struct Modifier {
  ModifierKind kind = ModifierKind::Settings;
  std::string mesh;  ///< path of a mesh file, or the name of a parametric part; empty for none
  std::optional<Mesh> volume = std::nullopt;            ///< mesh from the part's file, in its coordinates
  std::optional<Box3> box;                              ///< [mm, coordinates of the part's file]
  std::optional<std::pair<double, double>> heights_mm;  ///< lowest and highest, above the part's lowest point
  std::vector<SettingText> settings;                    ///< of kind `Settings` only
  std::string place;  ///< name in messages: file and index from 0, or volume of the part's file
};

/// Reads the list `modifiers` of a YAML file. Paths of meshes are relative to its folder unless they are
/// absolute or name a parametric part.
/// @throws InvalidConfig naming file, line and key; also for an unknown kind, and for settings that cannot
///   differ by region
/// @throws FileError
std::vector<Modifier> readModifiersFile(const std::string& path);

/// Modifiers made from the volumes of a part's file, and notes on what was left out.
struct VolumeModifiers {
  std::vector<Modifier> modifiers;
  std::vector<std::string> notes;  ///< a sentence for each volume of which something is left out
};

/// Makes modifiers from volumes that are cut away, from support blockers and enforcers, and from volumes with
/// settings of another slicer, as far as these can be `translated`. A volume whose settings are all left out
/// gives no modifier.
/// @param of_part  settings of the part; if its infill strategy cannot be combined with others, the settings
///   of all volumes are left out
VolumeModifiers modifiersOf(const std::vector<MeshVolume>& volumes, const JobSettings& of_part);

/// Reads the list `modifiers` of a YAML text, as `readModifiersFile`.
/// @param source_name  names the text in errors
/// @param folder       folder to which paths of meshes are relative
std::vector<Modifier> readModifiers(const std::string& yaml, const std::string& source_name,
                                    const std::string& folder);

}  // namespace lamina
