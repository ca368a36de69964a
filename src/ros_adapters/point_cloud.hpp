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

/// Reads the fields x, y and z (float32 or float64, in either order of bytes), whatever other fields there
/// are.
/// @param target_from_cloud  applied to each point; translation [mm]
/// @throws InvalidInput if a field is missing or of another type, or there are fewer bytes than the layout
///   requires
CloudPoints fromMessage(const sensor_msgs::PointCloud2& cloud, const Eigen::Isometry3d& target_from_cloud);

/// The rows of a cloud in its own frame [mm], each with all of its points, also those that are not finite,
/// and zeros. For the lines of a profile sensor.
/// @throws InvalidInput as `fromMessage`
std::vector<std::vector<Point3>> profilesFromMessage(const sensor_msgs::PointCloud2& cloud);

/// A cloud with the fields x, y and z (float32); the publisher sets the header.
/// @param points  [mm]
sensor_msgs::PointCloud2 toCloudMessage(const std::vector<Point3>& points);

/// A field of a cloud with a value for each point, in SI units.
struct CloudField {
  std::string name;
  std::vector<float> values;
};

/// A cloud with the fields x, y, z and further ones (float32); the publisher sets the header.
/// @param points  [mm]
/// @param fields  as many values each as there are points
sensor_msgs::PointCloud2 toCloudMessage(const std::vector<Point3>& points,
                                        const std::vector<CloudField>& fields);

/// A cloud with one point for each known cell, with the fields x, y, z and `deviation` (float32) [m]; the
/// deviation is NaN where it is not known.
/// @param deviation  map on the same grid as `heights`
sensor_msgs::PointCloud2 toCloudMessage(
    const HeightMap& heights, const HeightMap& deviation,
    const Eigen::Isometry3d& bed_from_maps = Eigen::Isometry3d::Identity());

/// The map as an image seen from above: 32FC1 [m], rows from the highest y downwards, NaN where unknown.
sensor_msgs::Image toImageMessage(const HeightMap& map);

}  // namespace lamina
