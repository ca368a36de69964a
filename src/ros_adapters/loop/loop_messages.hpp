// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <string>

#include "lamina/control/run/loop_run.hpp"
#include "messages.hpp"

namespace lamina {

/// The state of a loop as a message with an empty header: the publisher sets the time stamp.
/// @param run  null before the first toolpath
lamina_msgs::LoopState toMessage(const LoopRun* run);

/// The figures of a layer as a message with an empty header.
/// @param map_digest  digest of the layer's last map, as published
lamina_msgs::LoopFigures toMessage(const LayerOutcome& layer, const std::string& toolpath_id,
                                   const std::string& map_digest);

/// A cloud with a point for each cell at its planned position, with the error `e` and its standard deviation
/// `sigma` [m], and the correction `m` (all float32). For cells that were not measured, `e` is the loop's
/// prediction.
/// @param bed_from_part  translation [mm]
sensor_msgs::PointCloud2 toCloudMessage(const LayerOutcome& layer, const Eigen::Isometry3d& bed_from_part);
/// The same points with the `gain` (float32) that is learnt of each cell: actual over commanded growth.
sensor_msgs::PointCloud2 gainCloudMessage(const LayerOutcome& layer, const Eigen::Isometry3d& bed_from_part);

/// The request of a service call.
/// @throws InvalidInput if it is no request of SetLoop.srv
LoopRequest loopRequestOf(const lamina_msgs::SetLoop::Request& request);

}  // namespace lamina
