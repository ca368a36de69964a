// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Speed of a layer's travels, or of its last path if it has none [mm/s]. The layer has paths.
double travelFeed(const ToolpathLayer& layer);

/// What parking places over a layer depend on.
struct ParkingGround {
  Box3 part;  ///< box of what is deposited
  Point3 up;  ///< away from the layers
  /// Of what is deposited up to and with the layer, along `up` [mm]: other parts of a plate may be higher
  /// than the nozzle.
  double highest_mm = -std::numeric_limits<double>::infinity();
};

/// By layer.
std::vector<ParkingGround> parkingGrounds(const Toolpath& toolpath);

/// Where the nozzle waits, at the height where it is.
/// @param box  of the part
Point3 parkingPlace(const Point3& here, const Box3& box, ParkPlace place);

/// Retracted, up, to where the nozzle waits, and back to where it was. Its only event is a dwell of no time,
/// before the way back.
/// @param at        path at one end of which the nozzle stands: gives tool and orientation
/// @param waypoint  of that path
Path parkedWait(const Path& at, std::size_t waypoint, double travel_feed_mm_s, const ParkingGround& ground,
                const CoolingSettings& settings);

}  // namespace lamina
