// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <string>

#include "lamina/control/run/loop_run.hpp"
#include "messages.hpp"

namespace lamina {

/// The status with an empty header: the stamp belongs to the publisher.
/// @param run  null before the first toolpath
lamina_msgs::LoopState toMessage(const LoopRun* run);

/// A layer with an empty header.
/// @param map_digest  of the last map of the layer, as it was published
lamina_msgs::LoopFigures toMessage(const LayerOutcome& layer, const std::string& toolpath_id,
                                   const std::string& map_digest);

/// A point for each cell where it should be, with the error `e` and its standard deviation `sigma` [m] and
/// the correction `m` (all float32). Of cells that were not seen `e` is what the loop expects.
/// @param bed_from_part  translation [mm]
sensor_msgs::PointCloud2 toCloudMessage(const LayerOutcome& layer, const Eigen::Isometry3d& bed_from_part);

/// @throws InvalidInput if it is none of SetLoop.srv
LoopRequest loopRequestOf(const lamina_msgs::SetLoop::Request& request);

}  // namespace lamina
