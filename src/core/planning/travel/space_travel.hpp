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

/// Position and orientation of the nozzle.
struct NozzlePose {
  Point3 point = Point3::Zero();                                    ///< of the tip [mm, part frame]
  Eigen::Quaterniond orientation = Eigen::Quaterniond(0, 1, 0, 0);  ///< part_from_nozzle
};

/// The pose at the first waypoint of a path.
NozzlePose startPose(const Path& path);
/// The pose at the end of a path.
NozzlePose endPose(const Path& path);

/// The travel from one pose to another over layers that need not be level; none if their tips are the same
/// within 1e-6 mm. A travel up to the threshold moves away against the tool axis to the level of the other
/// tip, over, and down along the other tool axis. A longer one is retracted: against the tool axis by the
/// hop, vertically up to the hop above the highest tip, over, while the nozzle turns, and down likewise. On
/// level layers it equals that of `makeTravel`.
/// @param highest_mm  z of the highest tip that may be in the way [part frame]
std::optional<Path> makeSpaceTravel(const NozzlePose& from, const NozzlePose& to,
                                    const TravelSettings& settings, double highest_mm);

/// Makes travels by `makeSpaceTravel`, over all deposition up to and including the layer to which they lead.
/// @param standing_mm  highest z of solid material on the bed before the first layer
TravelMaker spaceTravels(const std::vector<ToolpathLayer>& layers, const TravelSettings& settings,
                         double standing_mm);

}  // namespace lamina
