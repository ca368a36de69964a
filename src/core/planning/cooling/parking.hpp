// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The deposition up to a layer, on which its parking place depends, and how the nozzle goes there.
struct ParkingGround {
  Box3 part;  ///< box of the deposition
  Point3 up;  ///< away from the layers
  /// Greatest height along `up` of the deposition up to and including the layer [mm]. Other parts of a plate
  /// may be higher than the nozzle.
  double highest_mm = -std::numeric_limits<double>::infinity();
  /// Speed of the layer's travels [mm/s]: without any, of those of the layer before, or else of the first
  /// layer that has some, or else of its last path.
  double travel_mm_s = 0.0;
};

/// The ground of each layer.
std::vector<ParkingGround> parkingGrounds(const Toolpath& toolpath);

/// Position at which the nozzle waits, at its present height.
/// @param box  bounding box of the part
Point3 parkingPlace(const Point3& here, const Box3& box, ParkPlace place);

/// The path to the parking place and back: retracted, up, across, and back the same way. Its only event is a
/// dwell of zero time before the way back. If the tool axis leans from the layers' normal, it is not known
/// whether there is room beside the part. Then the nozzle waits above the bead instead, moved out along its
/// axis by 5 mm, or by `cooling.lift_mm` if that is more.
/// @param at        path at one end of which the nozzle is; tool and orientation are taken from it
/// @param waypoint  of that path
Path parkedWait(const Path& at, std::size_t waypoint, double travel_feed_mm_s, const ParkingGround& ground,
                const CoolingSettings& settings);

/// Leads a wait on to where the next bead begins, at the height of the wait and down there, in place of the
/// way back and of the travels that followed it, which are taken away. Its dwell changes so that the next
/// bead begins when it did. Where the tool axis leans, or changes, the wait is not as high as the next bead,
/// or the travels change tools or carry events, the way stays; it is retracted then, so that the material is
/// pushed forth again where the next bead begins.
/// @param wait    of `parkedWait`
/// @param way     travels from the end of the wait to the next bead; without any, nothing changes
/// @param next    the next bead's path
/// @param ground  of the layer of the wait
void leadOn(Path& wait, std::vector<Path>& way, const Path& next, const ParkingGround& ground,
            const MotionLimits& limits);

}  // namespace lamina
