// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {

/// Where the nozzle is and how it is held.
struct NozzlePose {
  Point3 point = Point3::Zero();                                    ///< of the tip [mm, part frame]
  Eigen::Quaterniond orientation = Eigen::Quaterniond(0, 1, 0, 0);  ///< part_from_nozzle
};

/// Of the path's first waypoint.
NozzlePose startPose(const Path& path);
/// Where the nozzle is when the path is done.
NozzlePose endPose(const Path& path);

/// The motion without deposition from one pose to another over layers that need not be level, none if their
/// tips are the same within 1e-6 mm. Up to the threshold it draws back against the tool axis until it is
/// level with the other tip, goes over, and comes down along the other tool axis. Farther ones are retracted:
/// against the tool axis by the hop, straight up to the hop above the highest tip, over, where the nozzle
/// turns, and down likewise. On level layers that is what `makeTravel` makes.
/// @param highest_mm  z of the highest tip that may be in the way [part frame]
std::optional<Path> makeSpaceTravel(const NozzlePose& from, const NozzlePose& to,
                                    const TravelSettings& settings, double highest_mm);

/// That of `makeSpaceTravel`, over what is deposited up to the layer the travel leads to, and all of that
/// one.
TravelMaker spaceTravels(const std::vector<ToolpathLayer>& layers, const TravelSettings& settings);

}  // namespace lamina
