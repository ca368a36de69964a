// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What one straight motion deposits.
struct BeadOfMotion {
  Point3 from = Point3::Zero();  ///< of the tip [mm]
  Point3 to = Point3::Zero();
  Point3 tool_axis = -Point3::UnitZ();  ///< from the tip into the bead, of unit length
  Bead bead;
};

/// The bead as a solid for pictures: a prism below the motion, as wide and high as the bead, faces turned
/// outwards. Empty if the motion has no length or goes along the tool axis.
Mesh beadSolid(const BeadOfMotion& motion);

}  // namespace lamina
