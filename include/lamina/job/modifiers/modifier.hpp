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

/// What a modifier does.
enum class ModifierKind : std::uint8_t {
  Settings,        ///< other settings hold in it
  Negative,        ///< the part has no material in it
  SupportBlocker,  ///< what hangs in it is not held up
  SupportEnforcer  ///< all that hangs in it is held up
};

/// A region of a part: a mesh, a box or a range of heights.
struct Modifier {
  ModifierKind kind = ModifierKind::Settings;
  std::string mesh;  ///< path of a mesh file, or the name of a parametric part; empty for none
  std::optional<Mesh> volume = std::nullopt;            ///< of the part's file, in its coordinates
  std::optional<Box3> box;                              ///< [mm, coordinates of the part's file]
  std::optional<std::pair<double, double>> heights_mm;  ///< from and to, above the part's lowest point
  std::vector<SettingText> settings;
  std::string place;  ///< for messages: file and number, from 0
};

/// Reads the list `modifiers` of a YAML file. Meshes are relative to its folder unless they are absolute or
/// name a parametric part.
/// @throws InvalidConfig naming file, line and key: also for settings that no region can have for itself, and
///   for kinds that are not known; FileError
std::vector<Modifier> readModifiersFile(const std::string& path);

/// The volumes of a part's file as modifiers, and what of them is left out.
struct VolumeModifiers {
  std::vector<Modifier> modifiers;
  std::vector<std::string> notes;  ///< a sentence for each volume of which something is left out
};

/// Volumes that are cut away, blockers and enforcers of supports, and those with settings of another slicer
/// as far as these can be `translated`: one of which nothing is left is no modifier.
/// @param of_part  with a fill that cannot lie beside others, no volume has settings
VolumeModifiers modifiersOf(const std::vector<MeshVolume>& volumes, const JobSettings& of_part);

/// The same from text.
/// @param folder  of relative files
std::vector<Modifier> readModifiers(const std::string& yaml, const std::string& source_name,
                                    const std::string& folder);

}  // namespace lamina
