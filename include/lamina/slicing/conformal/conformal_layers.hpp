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
  double layer_height_mm = 0.0;  ///< height of each layer
  double deposited_mm3 = 0.0;    ///< volume of the layers
  double part_mm3 = 0.0;         ///< volume of the part that is filled; 0 for a coat
  /// Area that is not coated although it faces the direction of a coat, as other faces hide it.
  double hidden_mm2 = 0.0;
};

/// The layers of a coat on a mesh. A face is coated if its normal is within `conformal.max_tilt_deg` of the
/// direction of the settings, and no other face hides it from a viewer in that direction. Layers are stacked
/// outwards and end where they meet the mesh or each other. All have the same height: the thickness divided
/// by the least number of layers for which the height is at most `layer_height_mm`.
///
/// @param mesh  facing outwards [mm, part frame]; may be open
/// @throws Unsliceable if no face looks in that direction, or all that do are hidden; InvalidConfig if a
///   length is not positive or the direction zero; Cancelled
ConformalLayers coatingLayers(const Mesh& mesh, const ConformalSettings& settings, double layer_height_mm,
                              Progress& progress);

/// The layers of a part that follow a base: shells of the faces of the base whose normal is within
/// `conformal.max_tilt_deg` of the direction of the settings, as far as the shells lie inside the part.
/// Shells are cut where the signed distance to the part's surface is zero. The distance is interpolated
/// linearly between vertices that are at most `longest_edge_mm` apart on the base; cuts on plane walls are
/// exact.
///
/// @param part  closed, facing outwards [mm, part frame]
/// @param base  facing outwards, in the same frame; may be open
/// @throws Unsliceable if no face of the base looks in that direction, or the volume of the layers differs
///                     from that of the part by more than `largest_gap_percent`
/// @throws InvalidMesh if the part encloses no volume; InvalidConfig; Cancelled
ConformalLayers layersOnBase(const Mesh& part, const Mesh& base, const ConformalSettings& settings,
                             double layer_height_mm, Progress& progress);

}  // namespace lamina
