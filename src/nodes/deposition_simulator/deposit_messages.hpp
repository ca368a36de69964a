// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include "lamina/geometry/voxel/voxel_grid.hpp"
#include "lamina/job/deposit_job.hpp"
#include "messages.hpp"
#include "simulator_settings.hpp"

namespace lamina {

lamina_msgs::DepositionSummary toMessage(const DepositSummary& summary);

/// The middles of the voxels at the surface, in frame `bed`.
sensor_msgs::PointCloud2 depositedCloud(const VoxelGrid& grid, const ShownSettings& shown);

/// The surface as triangles, in frame `bed`.
visualization_msgs::MarkerArray depositedMarkers(const VoxelGrid& grid, const ShownSettings& shown);

}  // namespace lamina
