// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/mesh_io/mesh_objects.hpp"

namespace lamina {

/// A range of an object's triangles that is not material of the part, or has settings of its own.
struct VolumeRange {
  VolumeKind kind = VolumeKind::Modifier;
  std::size_t first = 0;                   ///< index of the first triangle
  std::size_t last = 0;                    ///< index of the last triangle, included
  std::vector<SettingText> settings = {};  ///< all metadata of the range, except those on its origin
};

/// Metadata of an object.
struct ObjectWords {
  std::vector<VolumeRange> volumes;
  std::vector<SettingText> settings;  ///< settings of the whole object
};

/// A range of heights of an object with settings of its own.
struct RangeOfHeights {
  double from_mm = 0.0;  ///< above the object's lowest point
  double to_mm = 0.0;
  std::vector<SettingText> settings;
};

/// Metadata of slicers in a 3MF file, beside the model, on how the part is printed.
struct SlicerWords {
  /// By index of the object among the model's objects, from 0.
  std::map<std::size_t, ObjectWords> objects;
  /// By index of the object among the built ones, from 0.
  std::map<std::size_t, std::vector<RangeOfHeights>> heights;
};

/// Reads the settings of volumes, objects and heights. `Metadata/Slic3r_PE_model.config` has ranges of
/// triangles, `Metadata/model_settings.config` whole objects; for Cura the model itself has the settings of
/// objects. Heights are in `Metadata/Prusa_Slicer_layer_config_ranges.xml` and
/// `Metadata/layer_config_ranges.xml`. Empty if there is none of these.
/// @throws InvalidMesh if one of these files cannot be parsed, has invalid heights, lists a part twice, or
///   refers to an object that the model does not have and gives it volumes that are not material
SlicerWords slicerWords(std::string_view archive, const std::string& name);

}  // namespace lamina
