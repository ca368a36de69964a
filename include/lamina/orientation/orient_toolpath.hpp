// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/orientation/orientation_report.hpp"
#include "lamina/orientation/orientation_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath with its nozzle oriented, and a report on how the nozzle rotates.
struct OrientedToolpath {
  Toolpath toolpath;
  OrientationReport report;
};

/// Orients the nozzle along a toolpath as the settings say. The tool axis follows from mode, lead and tilt,
/// smoothing, the limit on lean and the limit on turn, in this order. About the tool axis, the nozzle has the
/// frame that does not spin (`noSpinFrames`). Points, beads and feeds stay. A run whose orientation is the
/// same at all waypoints states it once. Travels whose own tool axes lead from the end of one run to the
/// start of the next keep their tool axes. Other travels are interpolated by the shortest rotation, in
/// proportion to their length; those before the first run and after the last have the orientation of that
/// run. Quaternions do not change sign from waypoint to waypoint, nor from path to path.
///
/// @param toolpath  with the orientations the slicer gave, tool axes against the layers' normals
/// @param part  mesh that was sliced [mm, part frame]; used in mode wall only
/// @return the same for any number of threads
/// @throws InvalidConfig as `requireConsistent`; InvalidInput if the tool axes of a whole run lie along v of
///   `noSpinFrame`, or the part has no walls to follow in mode wall; Cancelled
OrientedToolpath orientToolpath(Toolpath toolpath, const OrientationSettings& settings, const Mesh& part,
                                Progress& progress);

}  // namespace lamina
