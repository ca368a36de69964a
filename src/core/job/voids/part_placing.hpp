// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/job/voids/void_job.hpp"

namespace lamina {

/// program_from_part in x and y [mm]: where a program has put its part. Tried are the place that slicing with
/// the job's settings would choose, the part's own origin, and places where boxes or centroids of layers and
/// deposit agree (by their middle or by either side, a part may have features that are not printed), these
/// also rounded to where slicers put the middle of parts. What leaves least uncovered and overfilled is
/// taken, of equal ones the first.
/// @param contours  of the program's layers, in the part's frame
/// @param box       of the part
Point2 findPlace(const Toolpath& program, const std::vector<Regions>& contours, const Box3& box,
                 const VoidJob& job);

/// Box of the edges of all beads but skirts; empty if there are none.
Box2 depositedBox(const ToolpathLayer& layer);

}  // namespace lamina
