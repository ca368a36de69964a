// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "deposit_messages.hpp"

#include "conversions.hpp"
#include "lamina/geometry/voxel/voxel_view.hpp"
#include "names.hpp"
#include "point_cloud.hpp"

namespace lamina {

lamina_msgs::DepositionSummary toMessage(const DepositSummary& summary) {
  lamina_msgs::DepositionSummary message;
  message.path = toMetres(summary.totals.path_mm);
  message.extruded_volume = toCubicMetres(summary.totals.extruded_mm3);
  message.model_volume = toCubicMetres(summary.totals.deposited_mm3);
  message.excess_volume = toCubicMetres(summary.totals.excess_mm3);
  message.outside_volume = toCubicMetres(summary.totals.outside_mm3);
  message.voxel = toMetres(summary.voxel_mm);
  message.voxels = static_cast<std::uint64_t>(summary.voxels);
  message.porosity = summary.porosity;
  message.surface = toMetres(toMetres(summary.surface_mm2));
  message.highest = toMetres(summary.highest_mm);
  return message;
}

sensor_msgs::PointCloud2 depositedCloud(const VoxelGrid& grid, const ShownSettings& shown) {
  sensor_msgs::PointCloud2 cloud = toCloudMessage(shownVoxels(grid, static_cast<std::size_t>(shown.points)));
  cloud.header.stamp = ros::Time::now();
  cloud.header.frame_id = names::kBedFrame;
  return cloud;
}

visualization_msgs::MarkerArray depositedMarkers(const VoxelGrid& grid, const ShownSettings& shown) {
  const Mesh surface = shownSurface(grid, static_cast<std::size_t>(shown.triangles));
  visualization_msgs::Marker marker;
  marker.header.stamp = ros::Time::now();
  marker.header.frame_id = names::kBedFrame;
  marker.ns = "deposited";
  marker.type = visualization_msgs::Marker::TRIANGLE_LIST;
  marker.action =
      surface.triangles.empty() ? visualization_msgs::Marker::DELETE : visualization_msgs::Marker::ADD;
  marker.frame_locked = 1;  // it goes with a table that moves
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.r = 0.85F;
  marker.color.g = 0.55F;
  marker.color.b = 0.2F;
  marker.color.a = 1.0F;
  marker.points.reserve(3 * surface.triangles.size());
  for (const Triangle& corners : surface.triangles)
    for (const std::uint32_t vertex : corners) marker.points.push_back(toMessage(surface.vertices[vertex]));
  visualization_msgs::MarkerArray markers;
  markers.markers.push_back(std::move(marker));
  return markers;
}

}  // namespace lamina
