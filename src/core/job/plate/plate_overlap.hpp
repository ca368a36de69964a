// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A part where it stands.
struct StandingPart {
  std::string name;
  const Mesh* mesh = nullptr;  ///< its middle over the origin, bottom at z = 0
  Box3 box;                    ///< of the mesh
  Point2 at = Point2::Zero();  ///< of the origin [bed frame]

  Box3 boxOnBed() const;
};

/// Refuses parts that are in each other: sections of two parts whose boxes meet are compared every
/// `step_mm` of height. Parts may touch: 1e-3 mm² are no overlap.
/// @throws InvalidInput naming both, and where
void requireNoOverlap(const std::vector<StandingPart>& parts, double step_mm, Progress& progress);

/// Refuses parts that are not over the bed, or higher than the build space.
/// @param space  box of all tips [bed frame]
/// @throws Unreachable naming the first
void requireOnBed(const std::vector<StandingPart>& parts, const Box3& space, const std::string& machine);

}  // namespace lamina
