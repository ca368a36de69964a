// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/plate/plate.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// One request: which parts become one program, and how.
struct PlateJob {
  Plate plate;
  std::string output;    ///< as that of `SliceJob`
  JobSettings settings;  ///< of the plate, and of parts that have none of their own
};

/// What became of one part of a plate, or one copy of it.
struct PlatedPart {
  std::string name;
  std::string file;
  Point2 at_mm = Point2::Zero();   ///< middle of its box [bed frame]
  double arranged_turn_deg = 0.0;  ///< about z, by the arrangement
  Point3 size_mm = Point3::Zero();
  SliceSummary summary;  ///< of the part alone; without times and travels between parts
};

/// A plate ready to print.
struct SlicedPlate {
  SlicedPart sliced;              ///< the toolpath in the frame of the bed
  std::vector<PlatedPart> parts;  ///< in the order given, copies after their original
};

/// From mesh files to one written program: places the parts, plans each alone by its own settings (copies
/// once), and merges their layers by height or lays part after part, as `plate.order` says. One skirt stands
/// around all parts. Where the layers of another part begin, the toolpath has a `PartMark`.
///
/// Part by part, each may stand where no body of the machine's head could touch a finished one: the boxes of
/// the bodies, swept by all positions of the nozzle over the box of the part that is printed, against the
/// boxes of the parts before.
///
/// @throws as `runSliceJob`, with the name of the part in front; InvalidInput if parts overlap, naming both;
///   Unreachable if one does not stand on the bed, or the head would touch a finished one; InvalidConfig for
///   what plates do not take: layers that are not level, part.copies, scan passes, drop voids, vases layer by
///   layer
SlicedPlate runPlateJob(const PlateJob& job, Progress& progress);

}  // namespace lamina
