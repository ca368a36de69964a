// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/voids/void_map.hpp"

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
};

/// The part cut at half the height of each layer of the program, its bottom at that of the first layer, and
/// moved to where the program deposits: layer by layer the middle of the contours' box is compared with that
/// of what is deposited, and the median taken. If the middle of the whole part is then within 0.2 mm of a
/// multiple of half a millimetre in x and y, where slicers put parts, that is tried too; what leaves less
/// uncovered and overfilled is taken.
/// Without a part, each contour is what the closed outer walls of its layer enclose.
/// @throws InvalidMesh, FileError; InvalidInput if the program's layers do not rise, or if there is neither
/// part nor outer wall; Cancelled
PlacedContours placeContours(const Toolpath& program, const VoidJob& job, Progress& progress);

/// How well a program fills a part.
struct VoidReport {
  PlacedContours part;
  std::vector<LayerVoids> layers;
};

/// @param program  as read from a file
/// @throws as above
VoidReport runVoidJob(const Toolpath& program, const VoidJob& job, Progress& progress);

}  // namespace lamina
