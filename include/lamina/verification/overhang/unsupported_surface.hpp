// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What of a part's surface overhangs its own layers by more than the material takes.
struct UnsupportedSurface {
  double surface_mm2 = 0.0;  ///< of the whole part
  double unsupported_mm2 = 0.0;
  Mesh region;  ///< the triangles of it

  /// 0 of a part without surface.
  double percent() const { return surface_mm2 > 0.0 ? 100.0 * unsupported_mm2 / surface_mm2 : 0.0; }
};

/// Which overhangs count.
struct SupportQuestion {
  double max_overhang_deg =
      45.0;                     ///< 0 on a wall that layers grow along, 90 on an underside that they lie in
  double first_layer_mm = 0.2;  ///< what reaches no higher above the lowest place rests on the bed
};

/// Of plane layers that grow along a unit vector, by whole triangles. Linear in their number.
UnsupportedSurface unsupportedSurface(const Mesh& mesh, const Point3& growth,
                                      const SupportQuestion& question);

/// Of layers that grow against the tool axis, as it is at the nearest waypoint of the outer walls, or of all
/// that is deposited if there are none. Edges are halved until none is longer than a hundredth of the part's
/// diagonal.
/// @param toolpath  in the frame of the mesh
/// @param progress  stage "overhang"
/// @throws InvalidInput if nothing is deposited, or more than 20 million triangles would result; Cancelled
UnsupportedSurface unsupportedSurface(const Mesh& mesh, const Toolpath& toolpath,
                                      const SupportQuestion& question, Progress& progress);

}  // namespace lamina
