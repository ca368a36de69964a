// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/calibration/sensor_pose.hpp"

namespace lamina {

/// A point of a view: which profile saw it, and where.
struct SeenPoint {
  std::size_t profile = 0;
  Point3 in_sensor = Point3::Zero();  ///< [mm]
};

/// What of a recording can be placed on the bed but for the sensor's pose.
struct ViewPoints {
  std::vector<Eigen::Isometry3d> bed_from_nozzle;  ///< by profile
  std::vector<int> pass;                           ///< by profile: which it was seen in; -1 for none
  std::vector<SeenPoint> points;

  Point3 onBed(const SeenPoint& point, const Eigen::Isometry3d& nozzle_from_sensor) const {
    return bed_from_nozzle[point.profile] * (nozzle_from_sensor * point.in_sensor);
  }
  std::vector<Point3> onBed(const Eigen::Isometry3d& nozzle_from_sensor) const;
};

/// All points of profiles at whose time the nozzle's pose is known.
/// @throws InvalidInput if there are fewer than 100
ViewPoints viewPoints(const SensorRecording& recording, double time_offset_s);

/// Up to `most` of them, evenly chosen.
std::vector<std::size_t> evenlyChosen(const std::vector<std::size_t>& from, std::size_t most);

}  // namespace lamina
