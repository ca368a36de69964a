// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/job/voids/void_job.hpp"

namespace lamina {

/// Position of a part in a program: the shift program_from_part in x and y [mm]. Candidates are the position
/// that slicing with the job's settings would choose, the part's own origin, and shifts that match bounding
/// boxes or centroids of layers and deposit. Boxes are matched by their middles and by each side, as a part
/// may have features that are not printed. Each match is also tried rounded to the positions to which slicers
/// round the middle of parts. The candidate that leaves the least area uncovered and overfilled is chosen, of
/// equal ones the first.
/// @param contours  of the program's layers, in the part's frame
/// @param box       of the part
Point2 findPlace(const Toolpath& program, const std::vector<Regions>& contours, const Box3& box,
                 const VoidJob& job);

/// Bounding box of the edges of all beads but those of skirts; empty if there are none.
Box2 depositedBox(const ToolpathLayer& layer);

}  // namespace lamina
