// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// What is looked for when a part is placed on the bed.
struct LayingSettings {
  double overhang_deg = 45.0;    ///< faces that lean farther from the vertical hang
  double on_bed_mm = 0.2;        ///< faces below this height lie on the bed
  std::size_t most_faces = 500;  ///< of the hull that are tried, the largest
};

/// A part on one of the faces of its convex hull.
struct Laying {
  Point3 turn_deg = Point3::Zero();  ///< about the fixed axes x, y, z, in this order; z is 0
  double overhang_mm2 = 0.0;         ///< of hanging faces, as seen from below
  double height_mm = 0.0;
  double face_mm2 = 0.0;  ///< of the hull, on the bed
  double cost() const { return overhang_mm2 + 0.1 * height_mm; }
};

/// Ways to lay a part on its hull, that of the least cost first: what hangs, in mm², and a tenth of the
/// height, in mm. Of equal ones that with the larger face, then the smaller turn. Parallel over faces.
/// @throws InvalidMesh if the part is flat
std::vector<Laying> layings(const Mesh& part, const LayingSettings& settings);

}  // namespace lamina
