// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/multi_direction/direction_settings.hpp"
#include "slicing/multi_direction/cut_obstacles.hpp"
#include "slicing/multi_direction/piece_cells.hpp"

namespace lamina {

/// A part, and the rules for the cuts that are searched in it.
struct CutQuestion {
  const CellGraph& cells;
  const FacePolygons& faces;
  const DirectionSettings& settings;
  CutRules rules;
  double first_layer_mm = 0.2;  ///< height above the bed up to which the bed holds faces
};

/// Faces that overhang by more than is allowed in a piece printed along one direction, and their area.
struct HangingFaces {
  std::vector<std::uint32_t> faces;
  double area_mm2 = 0.0;
};

/// Faces that overhang by more than is allowed if the part is printed along +z, without those in the first
/// layer.
HangingFaces hangingFaces(const FacePolygons& faces, const CutQuestion& question);

/// Faces that overhang by more than is allowed if printed along the direction `up`.
std::vector<std::uint32_t> facesHangingAlong(const FacePolygons& faces, const Point3& up,
                                             const CutQuestion& question);

/// A sequence of cuts in the order in which they are found: the piece printed last is cut off first.
struct CutSequence {
  std::vector<CuttingPlane> cuts;
  /// Overhanging area of each piece that is cut off, when printed along its direction.
  std::vector<double> hanging_mm2;
  FacePolygons rest;  ///< faces below all cuts
  double cut_mm2 = 0.0;
};

/// The cut sequence that leaves the least overhanging area, by a beam search (see `directedPieces`).
/// @throws Cancelled
CutSequence bestCuts(const CutQuestion& question, Progress& progress);

/// The obstacle in each direction to further cuts of the rest that a sequence leaves.
/// @throws Cancelled
CutObstacles cutObstacles(const CutSequence& sequence, const CutQuestion& question, Progress& progress);

}  // namespace lamina
