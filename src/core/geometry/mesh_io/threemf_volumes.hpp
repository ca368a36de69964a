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

/// Triangles of an object that are no part of the part.
struct VolumeRange {
  VolumeKind kind = VolumeKind::Modifier;
  std::size_t first = 0;                   ///< triangle
  std::size_t last = 0;                    ///< triangle, that one too
  std::vector<SettingText> settings = {};  ///< all that is said of it
};

/// By the place of the object among those of the model, from 0.
using ObjectVolumes = std::map<std::size_t, std::vector<VolumeRange>>;

/// What slicers write beside the model of a 3MF file of volumes that change how a part is laid:
/// `Metadata/Slic3r_PE_model.config` gives ranges of triangles, `Metadata/model_settings.config` whole
/// objects. Nothing if there is neither.
/// @throws InvalidMesh if one of them cannot be read, or lists an object that the model does not have
ObjectVolumes objectVolumes(std::string_view archive, const std::string& name);

}  // namespace lamina
