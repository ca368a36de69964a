// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The wanted direction of growth at one place of a part: the layers' normal there, towards later layers.
struct DirectionSample {
  Point3 place = Point3::Zero();       ///< [mm]
  Point3 direction = Point3::UnitZ();  ///< of unit length
};

/// Reads samples from a table (CSV) with the columns x, y, z [mm] and nx, ny, nz, of any length but 0.
/// @throws FileError, Cancelled as `readFile`
/// @throws InvalidInput naming file and line if a number is missing or not finite, or a direction is 0;
///   naming the file if it has no row or lacks a column
std::vector<DirectionSample> readDirectionSamples(const std::string& path);

/// The samples after the part has been moved, turned or scaled; directions stay normal to the same layers.
/// @param transform  invertible
std::vector<DirectionSample> transformed(std::vector<DirectionSample> samples,
                                         const Eigen::Affine3d& transform);

}  // namespace lamina
