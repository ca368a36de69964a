// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

enum class LengthUnit { Millimetre, Centimetre, Metre, Inch };

/// The units by the names used on the command line and in requests: mm, cm, m, inch.
const std::vector<std::pair<std::string, LengthUnit>>& lengthUnits();

/// How the numbers of a mesh file become millimetres.
struct MeshUnits {
  LengthUnit unit = LengthUnit::Millimetre;  ///< of formats that state none: all but 3MF and STEP
  double scale = 1.0;                        ///< factor on top, for every format; positive
};

/// How finely the curved faces of solids (STEP) are divided into triangles.
struct Tessellation {
  double deflection_mm = 0.01;  ///< farthest that triangles lie from the face
  double deflection_deg = 5.0;  ///< greatest angle from edge to edge along a curve
};

/// Reads STL (binary or ASCII), OBJ, PLY (ASCII or binary), 3MF or STEP. The content decides the format, and
/// the suffix only where the content leaves it open. Vertices with exactly equal coordinates become one
/// (-0 equals +0); faces with more than three corners become fans. Nothing else is changed: degenerate
/// triangles and vertex order stay.
///
/// A wrong triangle count in a binary STL is corrected if the file holds whole triangles: more than the count
/// says, or fewer that form a closed surface.
///
/// STEP files [ISO10303-21] are read by Open CASCADE where Lamina was built with it: all solids where the
/// file places them, in millimetres whatever the unit of the file.
///
/// @throws FileError    if the file is missing or cannot be read, or is STEP and cannot be read here
/// @throws InvalidMesh  if it is empty, truncated, none of these formats, has a number that is not finite or
///                      beyond 1e9 mm, has no triangle, or is STEP without solids, with faces of none, or
///                      with a solid that lacks faces that cannot be read; names line or byte
/// @throws InvalidConfig if the scale is not positive and finite
Mesh readMesh(const std::string& path, const MeshUnits& units = {}, const Tessellation& tessellation = {});

/// The same. Solids, which take long to read, report the stage "read", and stop when they are cancelled.
/// @throws Cancelled if they are
Mesh readMesh(const std::string& path, const MeshUnits& units, const Tessellation& tessellation,
              Progress& progress);

/// The same for bytes in memory. The name stands for the path: in errors, and its suffix.
Mesh readMeshFromBytes(std::string_view bytes, const std::string& name, const MeshUnits& units = {},
                       const Tessellation& tessellation = {});

}  // namespace lamina
