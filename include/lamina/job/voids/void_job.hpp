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

/// One request: how well does a program fill a part?
struct VoidJob {
  std::string part;  ///< path of a mesh file, or the name of a parametric part (`partNames`); empty takes
                     ///< what the program's outer walls enclose
  JobSettings settings;
  VoidMapSettings map;
  std::optional<Point2> offset;  ///< program_from_part in x and y [mm]; found if it is not given
};

/// Where the part's layers are in a program.
struct PlacedContours {
  std::vector<Regions> contours;   ///< layer by layer [mm, frame of the program]
  Point2 offset = Point2::Zero();  ///< program_from_part [mm]
  /// Layers of the part that the program lacks, above its last one or between others: all uncovered.
  std::vector<LayerVoids> missing;
};

/// The part cut at half the height of each layer of the program, its bottom at that of the first layer, and
/// moved to where the program deposits. Tried are the place that slicing with the job's settings would
/// choose, the part's own origin, and those where the boxes of layers and deposit agree, by their middle or
/// by either side, or where their centroids do; places near which the middle of the part is on multiples of
/// half a millimetre, where slicers put parts, are tried there as well. Of all these the one is taken that
/// leaves least uncovered and overfilled on some layers. Without a part, each contour is what the closed
/// outer walls of its layer enclose.
/// @throws InvalidMesh, FileError; InvalidInput if most layers lay boxes of another size than those of the
/// part's sections: another part, or scale; if the offset is not finite, the layers are inclined, the
/// program's layers do not rise, or if there is neither part nor outer wall; Cancelled
PlacedContours placeContours(const Toolpath& program, const VoidJob& job, Progress& progress);

/// How well a program fills a part.
struct VoidReport {
  PlacedContours part;
  std::vector<LayerVoids> layers;  ///< of the program
};

/// Sums over the layers of the program and, behind these, those that it lacks, which count as layers that
/// nothing covers. `layers` and `runs_per_layer_mean` are the program's.
VoidTotals totals(const VoidReport& report);

/// @param program  as read from a file
/// @throws as above
VoidReport runVoidJob(const Toolpath& program, const VoidJob& job, Progress& progress);

}  // namespace lamina
