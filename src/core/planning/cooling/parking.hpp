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
  /// Speed of the layer's travels [mm/s]. In a layer without travels it is that of the layer before, else of
  /// the first layer with travels, else of the layer's last path.
  double travel_mm_s = 0.0;
};

/// The ground of each layer.
std::vector<ParkingGround> parkingGrounds(const Toolpath& toolpath);

/// Position at which the nozzle waits, at its present height; higher where it would otherwise be below the
/// plane of its layer, within what is deposited. Beside inclined layers, the corner is the side of the part
/// at low x: the corner itself can be the length of the part above the layer or below it.
/// @param box  bounding box of the part
/// @param up   normal of the layers
Point3 parkingPlace(const Point3& here, const Box3& box, ParkPlace place, const Point3& up);

/// The path to the parking place and back: retracted, up, across, and back along the same line. Its only
/// event is a dwell of zero time at the parking place. If the tool axis leans from the layers' normal, it is
/// not known whether there is room beside the part. The nozzle then waits above the bead, backed off along
/// the tool axis by 5 mm or `cooling.lift_mm`, whichever is more.
/// @param at        path with the nozzle at one end; gives tool and orientation
/// @param waypoint  of that path
Path parkedWait(const Path& at, std::size_t waypoint, double travel_feed_mm_s, const ParkingGround& ground,
                const CoolingSettings& settings);

/// Continues a wait directly to the start of the next bead: across at the height of the wait, then down. The
/// return to the bead and the travels after it are removed. The dwell is adjusted so that the next bead
/// begins at the same time as before. Nothing is moved if the tool axis leans or changes, if the wait is
/// lower than the next bead, or if the travels change tools or carry events. The travels are then marked as
/// retracted: the retraction ends where the next bead begins.
/// @param wait    of `parkedWait`
/// @param way     travels from the end of the wait to the next bead; without any, nothing changes
/// @param next    the next bead's path
/// @param ground  of the layer of the wait
void leadOn(Path& wait, std::vector<Path>& way, const Path& next, const ParkingGround& ground,
            const MotionLimits& limits);

}  // namespace lamina
