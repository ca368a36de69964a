// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/multi_direction/direction_settings.hpp"
#include "slicing/multi_direction/piece_cells.hpp"

namespace lamina {

/// What is looked for cuts in.
struct CutQuestion {
  const CellGraph& cells;
  const FacePolygons& faces;
  const DirectionSettings& settings;
  CutRules rules;
  double first_layer_mm = 0.2;  ///< faces up to there are held by the bed
};

/// Surface that hangs over more than is taken, in a piece that one direction is printed along [mm²].
struct HangingFaces {
  std::vector<std::uint32_t> faces;
  double area_mm2 = 0.0;
};

/// Faces that hang along +z and do not belong to the first layer.
HangingFaces hangingFaces(const FacePolygons& faces, const CutQuestion& question);

/// Faces that overhang by more than is taken from a direction.
std::vector<std::uint32_t> facesHangingAlong(const FacePolygons& faces, const Point3& up,
                                             const CutQuestion& question);

/// Cuts in the order in which they are found: the last piece first.
struct CutSequence {
  std::vector<CuttingPlane> cuts;
  std::vector<double> hanging_mm2;  ///< of each piece that is cut off, along its direction
  FacePolygons rest;                ///< of the surface, below all cuts
  double cut_mm2 = 0.0;
};

/// The sequence that leaves least, by a beam search (`directedPieces`).
/// @throws Cancelled
CutSequence bestCuts(const CutQuestion& question, Progress& progress);

}  // namespace lamina
