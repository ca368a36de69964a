// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/voids/beads/void_map.hpp"
#include "lamina/voids/beads/void_totals.hpp"

namespace lamina {

/// A request to measure how well a program fills a part.
struct VoidJob {
  /// Path of a mesh file, or the name of a parametric part (`partNames`); empty for what the program's outer
  /// walls enclose.
  std::string part;
  JobSettings settings;
  VoidMapSettings map;
  std::optional<Point2> offset;  ///< program_from_part in x and y [mm]; nothing to find it
};

/// Contours of the part in the layers of a program.
struct PlacedContours {
  std::vector<Regions> contours;   ///< layer by layer [mm, frame of the program]
  Point2 offset = Point2::Zero();  ///< program_from_part [mm]
  /// Layers of the part that the program lacks, above its last layer or between others; they count as wholly
  /// uncovered.
  std::vector<LayerVoids> missing;
  /// Description of the first layer whose section differs from the part's, if the compared layers beside it
  /// agree with the part; empty if there is none.
  std::string other_section;
};

/// Cuts the part at half the height of each layer of the program, with its bottom at that of the first layer,
/// and moves the contours to the position at which the program deposits them. Candidates are the position
/// that slicing with the job's settings would choose, the part's own coordinates, and positions at which the
/// bounding boxes of contours and deposit agree in their middle or on one side, or their centroids agree.
/// Near each of these, positions that put the middle of the part on multiples of half a millimetre, as
/// slicers do, are tried too. The candidate with the least uncovered and overfilled area on a few layers is
/// used. A part that shrinks (`compensation.shrink_*`) is as large as it is printed. Without a part, the
/// contour of each layer is the area that its closed outer walls enclose.
/// @throws InvalidMesh, FileError
/// @throws InvalidInput if the bounding boxes of deposit and contour differ in size in most layers, as for
///   another part or scale; if most compared layers, or two in succession, have beads outside the part or
///   holes without beads that the part does not have; if the offset is not finite, the layers are inclined,
///   or the program's layers do not rise; if there is neither part nor outer wall
/// @throws Cancelled
PlacedContours placeContours(const Toolpath& program, const VoidJob& job, Progress& progress);

/// How well a program fills a part.
struct VoidReport {
  PlacedContours part;
  std::vector<LayerVoids> layers;  ///< layers of the program
};

/// Sums over the layers of the program and those that it lacks, which count as wholly uncovered. Only
/// `layers` and `runs_per_layer_mean` are of the program's layers alone.
VoidTotals totals(const VoidReport& report);

/// Measures how well a program fills a part.
/// @param program  as read from a file
/// @throws as `placeContours`, `findVoids`
VoidReport runVoidJob(const Toolpath& program, const VoidJob& job, Progress& progress);

}  // namespace lamina
