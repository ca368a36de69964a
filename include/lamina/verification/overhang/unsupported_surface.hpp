// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The surface of a part that overhangs its own layers by more than the material can bear.
struct UnsupportedSurface {
  double surface_mm2 = 0.0;      ///< area of the whole surface
  double unsupported_mm2 = 0.0;  ///< area of the surface that is unsupported
  Mesh region;                   ///< triangles that are unsupported

  /// Unsupported share of the surface [%]; 0 of an empty surface.
  double percent() const { return surface_mm2 > 0.0 ? 100.0 * unsupported_mm2 / surface_mm2 : 0.0; }
};

/// Which surface counts as unsupported.
struct SupportCriteria {
  /// Greatest overhang that is supported; 0 is a wall along the direction in which layers are stacked, 90 an
  /// underside parallel to the layers.
  double max_overhang_deg = 45.0;
  double first_layer_mm = 0.2;  ///< height above the lowest point up to which triangles rest on the bed
};
/// The unsupported surface of a part in plane layers, by whole triangles. Takes time linear in their number.
/// @param growth  unit vector in which layers are stacked, their normal [frame of the mesh]
UnsupportedSurface unsupportedSurface(const Mesh& mesh, const Point3& growth,

                                      const SupportCriteria& question);
/// The unsupported surface of a part in the layers of a toolpath, which are stacked against the tool axis.
/// Each triangle gets the tool axis of the nearest motion of the outer walls, or of all beads if there are
/// none; triangles nearest to the first layer are supported. Edges are first halved until none is longer than
/// a hundredth of the part's diagonal.
/// @param toolpath  in the frame of the mesh
/// @param progress  stage "overhang"
/// @throws InvalidInput if nothing is deposited, or more than 20 million triangles would result; Cancelled
UnsupportedSurface unsupportedSurface(const Mesh& mesh, const Toolpath& toolpath,
                                      const SupportCriteria& question, Progress& progress);

}  // namespace lamina
