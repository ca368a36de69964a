// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/geometry/voxel/height_map.hpp"

namespace lamina {

/// The points of a cloud.
struct CloudPoints {
  std::vector<Point3> points;  ///< [mm]
  std::size_t not_finite = 0;  ///< points with a NaN or infinite coordinate, or exactly zero, left out
};

/// Reads the fields x, y and z (float32), whatever other fields there are.
/// @param target_from_cloud  applied to each point; translation [mm]
/// @throws InvalidInput if a field is missing or of another type, the bytes are swapped, or there are fewer
///   bytes than the layout asks for
CloudPoints fromMessage(const sensor_msgs::PointCloud2& cloud, const Eigen::Isometry3d& target_from_cloud);

/// The rows of a cloud in its own frame [mm], all points of each, not finite ones and zeros too: a profile
/// sensor's lines.
/// @throws InvalidInput as the other
std::vector<std::vector<Point3>> profilesFromMessage(const sensor_msgs::PointCloud2& cloud);

/// A cloud with the fields x, y and z (float32). Header: the publisher's.
/// @param points  [mm]
sensor_msgs::PointCloud2 toCloudMessage(const std::vector<Point3>& points);

/// A value of each point of a cloud, in SI units.
struct CloudField {
  std::string name;
  std::vector<float> values;
};

/// A cloud with the fields x, y and z and others (float32). Header: the publisher's.
/// @param points  [mm]
/// @param fields  as many values each as there are points
sensor_msgs::PointCloud2 toCloudMessage(const std::vector<Point3>& points,
                                        const std::vector<CloudField>& fields);

/// One point per known cell, with the fields x, y, z and `deviation` (float32) [m], the last NaN where
/// unknown.
/// @param deviation  of the same grid as `heights`
sensor_msgs::PointCloud2 toCloudMessage(
    const HeightMap& heights, const HeightMap& deviation,
    const Eigen::Isometry3d& bed_from_maps = Eigen::Isometry3d::Identity());

/// The map as seen from above: 32FC1 [m], rows from the highest y down, NaN where unknown.
sensor_msgs::Image toImageMessage(const HeightMap& map);

}  // namespace lamina
