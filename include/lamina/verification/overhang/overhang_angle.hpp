// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How far walls lean outwards over what carries them. A wall that leans by an angle t from the direction of
/// growth puts each layer of height h out by h tan t over the one before; what goes beyond a bead's width is
/// deposited on air. Faces that the first layer lies along rest on the bed, or on what takes its place.
struct OverhangAngle {
  double greatest_rad = 0.0;            ///< greatest lean of a wall, 0 to pi / 2; 0 if none leans outwards
  Point3 greatest_at = Point3::Zero();  ///< where [mm, frame of the mesh]
  double overhang_mm = 0.0;             ///< h tan t there; infinite on level undersides
  double area_mm2 = 0.0;                ///< of the whole surface
  double beyond_bead_mm2 = 0.0;  ///< of the surface that leans so that a layer is put out by more than a bead

  /// Part of the surface; 0 if there is none.
  double shareBeyondBead() const { return area_mm2 > 0.0 ? beyond_bead_mm2 / area_mm2 : 0.0; }
};

/// Layers that grow all one way, as level or inclined ones. Linear in the number of triangles.
/// A wall should not overhang by more than one bead width per layer [Flores2018, section 4.3.3].
/// @param growth  unit vector, the layers' normal [frame of the mesh]
/// @param bead    width, and height of the layers [mm]
OverhangAngle overhangAngle(const Mesh& mesh, const Point3& growth, const Bead& bead);

/// Layers that grow against the tool axis: at each triangle as at the nearest waypoint of the outer walls, or
/// of all that is deposited if there are no walls. Time is O(n log n).
/// @param toolpath   in the frame of the mesh
/// @param width_mm   of a bead
/// @throws InvalidInput if nothing is deposited
OverhangAngle overhangAngle(const Mesh& mesh, const Toolpath& toolpath, double width_mm);

}  // namespace lamina
