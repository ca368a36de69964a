// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// How orientations of a part on the bed are judged.
struct LayingSettings {
  double overhang_deg = 45.0;    ///< a face overhangs if it leans farther than this from the vertical
  double on_bed_mm = 0.2;        ///< faces no higher than this above the bed count as lying on it
  std::size_t most_faces = 500;  ///< greatest number of the hull's faces that are tried, the largest first
};

/// An orientation in which a part lies on a face of its convex hull.
struct Laying {
  /// Rotations about the fixed axes x, y, z, in this order; the rotation about z is 0.
  Point3 turn_deg = Point3::Zero();
  double overhang_mm2 = 0.0;  ///< area of overhanging faces, projected to the bed
  double height_mm = 0.0;
  double face_mm2 = 0.0;  ///< area of the hull's face on the bed
  /// The lower the better: overhang in mm² and a tenth of the height in mm.
  double cost() const { return overhang_mm2 + 0.1 * height_mm; }
};

/// Orientations of a part on the faces of its convex hull, the least cost first. Among equal costs the larger
/// face comes first, then the smaller rotation. Computed by several threads.
/// @throws InvalidMesh if the part is flat
std::vector<Laying> layings(const Mesh& part, const LayingSettings& settings);

}  // namespace lamina
