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
  LengthUnit unit = LengthUnit::Millimetre;  ///< for formats that state none: all except 3MF and STEP
  double scale = 1.0;                        ///< additional factor, for every format; positive
};

/// How finely the curved faces of solids (STEP) are divided into triangles.
struct Tessellation {
  double deflection_mm = 0.01;  ///< greatest distance of triangles from the face
  double deflection_deg = 5.0;  ///< greatest angle between consecutive edges along a curve
};

/// Reads a mesh from STL (binary or ASCII), OBJ, PLY (ASCII or binary), 3MF or STEP. The content decides the
/// format, and the suffix only where the content leaves it open. Vertices with exactly equal coordinates
/// become one (-0 equals +0); faces with more than three corners become fans of triangles. Nothing else is
/// changed: degenerate triangles and the order of vertices stay.
///
/// A wrong triangle count in a binary STL is corrected if the file holds whole triangles: more than the count
/// states, or fewer that form a closed surface.
///
/// STEP files [ISO10303-21] are read by Open CASCADE if Lamina was built with it: all solids where the file
/// places them, in millimetres whatever the unit of the file.
///
/// @throws FileError    if the file is missing or cannot be read, or is STEP and Lamina was built without
///   Open CASCADE
/// @throws InvalidMesh  naming line or byte, if the file is empty, truncated or of no known format; has a
///   number that is not finite or beyond 1e9 mm; or has no triangle. For STEP, if it has no solid, faces that
///   belong to no solid, or solids with faces that cannot be read
/// @throws InvalidConfig if the scale is not positive and finite
Mesh readMesh(const std::string& path, const MeshUnits& units = {}, const Tessellation& tessellation = {});

/// The same, with progress: STEP files, which take long to read, report the stage "read" and can be
/// cancelled.
/// @throws Cancelled
Mesh readMesh(const std::string& path, const MeshUnits& units, const Tessellation& tessellation,
              Progress& progress);

/// Reads a mesh from bytes in memory, as `readMesh`.
/// @param name  replaces the path: in errors, and for its suffix
Mesh readMeshFromBytes(std::string_view bytes, const std::string& name, const MeshUnits& units = {},
                       const Tessellation& tessellation = {});

}  // namespace lamina
