// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/conformal/conformal_settings.hpp"
#include "lamina/slicing/curved/shell_propagation.hpp"
#include "lamina/slicing/unsliceable.hpp"

namespace lamina {

/// Layers that follow a given surface, in the order in which they are deposited.
struct ConformalLayers {
  std::vector<LayerSurface> layers;
  double layer_height_mm = 0.0;  ///< of each
  double deposited_mm3 = 0.0;
  double part_mm3 = 0.0;  ///< of the part that is filled; 0 for a coat
  /// Of faces that look in the direction of a coat, but lie below other faces: not coated.
  double hidden_mm2 = 0.0;
};

/// A coat on a mesh: layers on its faces that look in the direction of the settings and have no other face
/// before them, seen from there, growing outwards and ending where they meet the mesh or each other. As many
/// layers of equal height, at most `layer_height_mm`, as give the thickness exactly.
///
/// @param mesh  facing outwards [mm, part frame]; may be open
/// @throws Unsliceable if no face looks in that direction, or all that do are hidden; InvalidConfig;
/// Cancelled
ConformalLayers coatingLayers(const Mesh& mesh, const ConformalSettings& settings, double layer_height_mm,
                              Progress& progress);

/// A part in layers that follow a base: shells of the faces of the base that look in the direction of the
/// settings, as far as they lie inside the part. They are cut where the distance to the part's surface,
/// linear between vertices at most `longest_edge_mm` apart in the base, is zero: on plane walls exactly.
///
/// @param part  closed, facing outwards [mm, part frame]
/// @param base  facing outwards, in the same frame; may be open
/// @throws Unsliceable if no face of the base looks in that direction, or the layers leave (or lay too much)
///                     more than `largest_gap_percent` of the part
/// @throws InvalidMesh if the part holds no volume; InvalidConfig; Cancelled
ConformalLayers layersOnBase(const Mesh& part, const Mesh& base, const ConformalSettings& settings,
                             double layer_height_mm, Progress& progress);

}  // namespace lamina
