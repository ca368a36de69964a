// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/plate/plate.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// A request to make one program from the parts of a plate.
struct PlateJob {
  Plate plate;
  std::string output;    ///< as in `SliceJob`
  JobSettings settings;  ///< settings of the plate, and of parts without settings of their own
};

/// Report on one part of a plate, or on one copy of it.
struct PlatedPart {
  std::string name;
  std::string file;
  Point2 at_mm = Point2::Zero();  ///< middle of its bounding box [bed frame]
  /// Rotation about z by the arrangement, in addition to the requested rotation.
  double arranged_turn_deg = 0.0;
  Point3 size_mm = Point3::Zero();
  SliceSummary summary;  ///< figures of the part alone, without times and travels between parts
};

/// A plate ready to print.
struct SlicedPlate {
  /// Toolpath of all parts: in the bed frame; in inclined layers on a belt, in the frame of the first part.
  SlicedPart sliced;
  std::vector<PlatedPart> parts;  ///< in the order requested, copies after their original
};

/// Slices the parts of a plate into one program and writes it. Each part is placed and planned alone by its
/// own settings (copies once). Then the layers are merged by height, or parts follow each other whole, as
/// `plate.order` asks. On level layers one skirt runs around all parts. The toolpath has a `PartMark`
/// wherever the layers of another part begin. In inclined layers on a belt, parts follow each other along the
/// belt.
///
/// If parts follow each other whole on a bed, no part may stand where a body of the machine's head could
/// touch a finished part. This compares the bounding boxes of the bodies, swept over all positions of the
/// nozzle within the box of the part being printed, with the boxes of the parts before.
///
/// @throws as `runSliceJob`, with the name of the part in front
/// @throws InvalidInput if there is no part, or parts overlap, naming both
/// @throws Unreachable if a part does not stand on the bed, or the head would touch a finished part
/// @throws InvalidConfig for what plates do not support: layers that are not plane, part.copies, scan passes,
///   drop voids, prime lines and skirts of several layers; infill that goes on from layer to layer (vases) if
///   several parts are merged by height; prime towers except on level layers that are merged by height;
///   inclined layers with plate.order by_part without a belt, or with at_mm on a belt; by_part if no body of
///   the head is described
SlicedPlate runPlateJob(const PlateJob& job, Progress& progress);

}  // namespace lamina
