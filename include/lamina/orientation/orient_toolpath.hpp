// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/orientation/orientation_report.hpp"
#include "lamina/orientation/orientation_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath with its nozzle oriented, and how it turns.
struct OrientedToolpath {
  Toolpath toolpath;
  OrientationReport report;
};

/// Holds the nozzle along a toolpath as the settings say: the tool axis by mode, lead and tilt, smoothing,
/// limits on lean and then on turn, and about each tool axis the frame that does not spin. Points, beads and
/// feeds stay. Runs whose orientation is the same at all waypoints hold it once. Travels whose own tool axes
/// lead from the end of one run to the start of the next keep these; others turn in proportion to their
/// length, the shortest way; before the first run and after the last they hold what that has. From waypoint
/// to waypoint, also from path to path, quaternions keep their sign.
///
/// @param toolpath  with the orientations the slicer gave, tool axes against the layers' normals
/// @param part      what it was sliced from [mm, part frame]; read in mode wall only
/// @return the same for any number of threads
/// @throws InvalidConfig as `requireConsistent`; InvalidInput if a whole run's tool axis lies across the
/// heading, or a part has no walls to follow; Cancelled
OrientedToolpath orientToolpath(Toolpath toolpath, const OrientationSettings& settings, const Mesh& part,
                                Progress& progress);

}  // namespace lamina
