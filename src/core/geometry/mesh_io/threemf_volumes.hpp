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

/// Triangles of an object that are no part of the part, or have settings of their own.
struct VolumeRange {
  VolumeKind kind = VolumeKind::Modifier;
  std::size_t first = 0;                   ///< triangle
  std::size_t last = 0;                    ///< triangle, that one too
  std::vector<SettingText> settings = {};  ///< all that is said of it, but for where it came from
};

/// What is said of an object.
struct ObjectWords {
  std::vector<VolumeRange> volumes;
  std::vector<SettingText> settings;  ///< of all of it
};

/// Heights of an object with settings of their own.
struct RangeOfHeights {
  double from_mm = 0.0;  ///< above the object's lowest point
  double to_mm = 0.0;
  std::vector<SettingText> settings;
};

/// What slicers write beside the model of a 3MF file of how a part is printed.
struct SlicerWords {
  /// By the place of the object among those of the model, from 0.
  std::map<std::size_t, ObjectWords> objects;
  /// By the place of the object among those that are built, from 0.
  std::map<std::size_t, std::vector<RangeOfHeights>> heights;
};

/// Settings of volumes and objects: `Metadata/Slic3r_PE_model.config` gives ranges of triangles,
/// `Metadata/model_settings.config` whole objects, and for Cura's objects the model itself. Settings of
/// heights: `Metadata/Prusa_Slicer_layer_config_ranges.xml` and `Metadata/layer_config_ranges.xml`. Empty
/// where there is none of them.
/// @throws InvalidMesh if one of them cannot be read, has heights that are none, lists a part twice, or an
///   object with volumes that are no material which the model does not have
SlicerWords slicerWords(std::string_view archive, const std::string& name);

}  // namespace lamina
