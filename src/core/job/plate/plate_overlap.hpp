// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A part at its position on the bed.
struct StandingPart {
  std::string name;
  const Mesh* mesh = nullptr;  ///< its middle over the origin, its bottom at z = 0
  Box3 box;                    ///< of the mesh
  Point2 at = Point2::Zero();  ///< position of the mesh's origin [bed frame]
  /// Offsets from the first tool's nozzle of the nozzles that print it [bed frame]; empty: the first nozzle
  /// alone.
  std::vector<Point3> nozzles_mm = {};
  Regions beside = {};  ///< what is laid on the bed beside it, such as a brim, round the mesh's origin

  Box3 boxOnBed() const;
  Box3 boxBesides() const;  ///< with what lies beside it, as high as the part
};

/// Refuses parts that intersect: sections of two parts whose boxes overlap are compared every `step_mm` of
/// height. Parts may touch: an overlap of up to 1e-3 mm² is allowed.
/// @throws InvalidInput naming both parts and the place
void requireNoOverlap(const std::vector<StandingPart>& parts, double step_mm, Progress& progress);

/// Refuses brims and rafts that meet another part's first layer, or its brim or raft.
/// @param first_layer_mm  height of the first layer, which is cut in its middle
/// @throws InvalidInput naming both parts and the place
void requireNoneBesideOverlaps(const std::vector<StandingPart>& parts, double first_layer_mm,
                               Progress& progress);

/// Refuses parts that are not wholly over the bed, or higher than the build space.
/// @param space  bounding box of all positions of the tip [bed frame]
/// @throws Unreachable naming the first
void requireOnBed(const std::vector<StandingPart>& parts, const Box3& space, const std::string& machine);

}  // namespace lamina
