// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>

#include "recording_table.hpp"

namespace lamina {

/// A pose in a row, by the columns x_mm, y_mm, z_mm, qw, qx, qy and qz behind a prefix [mm].
/// @throws InvalidInput if a column is missing or the quaternion is not of unit length within 1 %
Eigen::Isometry3d tablePose(const RecordingTable& table, std::size_t row, const std::string& prefix);

/// A pose in a row, by the columns x_mm, y_mm, z_mm, and rx_deg, ry_deg, rz_deg: turns about the fixed axes
/// x, then y, then z [mm].
/// @throws InvalidInput if a column is missing
Eigen::Isometry3d poseByAngles(const RecordingTable& table, std::size_t row);

/// A point in a row, by the columns x_mm, y_mm and z_mm behind a prefix [mm].
/// @throws InvalidInput if a column is missing
Eigen::Vector3d tablePoint(const RecordingTable& table, std::size_t row, const std::string& prefix);

}  // namespace lamina
