// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Overhang of walls. On a wall that leans outwards by an angle t from the direction in which layers are
/// stacked, each layer of height h projects by h tan t beyond the one before; if that exceeds the width of a
/// bead, the bead is deposited in air. Faces in the first layer rest on the bed, or on what replaces it, and
/// do not overhang.
struct OverhangAngle {
  double greatest_rad = 0.0;            ///< greatest outward lean t, 0 to pi / 2; 0 if no wall leans outwards
  Point3 greatest_at = Point3::Zero();  ///< middle of the triangle that has it [mm, frame of the mesh]
  double overhang_mm = 0.0;             ///< h tan t of that triangle; infinite if it is a level underside
  double area_mm2 = 0.0;                ///< area of the whole surface
  double beyond_bead_mm2 = 0.0;         ///< area where layers project by more than the width of a bead

  /// Share of that area in the surface; 0 of an empty surface.
  double shareBeyondBead() const { return area_mm2 > 0.0 ? beyond_bead_mm2 / area_mm2 : 0.0; }
};

/// The overhang of plane layers, level or inclined. Takes time linear in the number of triangles. A wall
/// should not overhang by more than one bead width per layer [Flores2018, section 4.3.3].
/// @param growth  unit vector in which layers are stacked, their normal [frame of the mesh]
/// @param bead    its width, and the height of the layers [mm]
OverhangAngle overhangAngle(const Mesh& mesh, const Point3& growth, const Bead& bead);

/// The overhang of the layers of a toolpath, which are stacked against the tool axis. Each triangle gets the
/// tool axis of the nearest motion of the outer walls, or of all beads if there are no walls. Time is O(n log
/// n).
/// @param toolpath   in the frame of the mesh
/// @param width_mm   of a bead
/// @throws InvalidInput if nothing is deposited
OverhangAngle overhangAngle(const Mesh& mesh, const Toolpath& toolpath, double width_mm);

}  // namespace lamina
