// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/verification/collision/joint_clearance.hpp"

namespace lamina {

/// How near a link comes to a body that stands in the cell (`cell.bodies` of a cell file).
struct FenceDistance {
  double distance_mm = 0.0;  ///< 0 where they are in each other
  std::string link;
  std::size_t body = 0;  ///< index of the body in the cell file
  WaypointIndex at;  ///< where the link is so near; of a way beside the part the waypoint that it leads to
};

/// The least distance of links that move to the bodies of the cell file, at the stations of a joint path and
/// at the values of passages. Between two of them a link may come nearer by half of what it moves there.
/// Meshes count as they are, not by their hulls. Pairs of links that are ignored count neither.
/// @return nothing without such a body, or without values
std::optional<FenceDistance> nearestToFences(const JointRun& run, const std::vector<JointPassage>& passages,
                                             const LinkBodies& bodies);

}  // namespace lamina
