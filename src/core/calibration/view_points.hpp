// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/calibration/sensor_pose.hpp"

namespace lamina {

/// A point that the sensor measured, with the index of its profile.
struct SeenPoint {
  std::size_t profile = 0;
  Point3 in_sensor = Point3::Zero();  ///< [mm]
};

/// Points of a recording, ready to be placed on the bed once the sensor's pose is known.
struct ViewPoints {
  std::vector<Eigen::Isometry3d> bed_from_nozzle;  ///< pose of the nozzle at each profile
  std::vector<int> pass;                           ///< index of the pass of each profile; -1 for none
  std::vector<SeenPoint> points;

  Point3 onBed(const SeenPoint& point, const Eigen::Isometry3d& nozzle_from_sensor) const {
    return bed_from_nozzle[point.profile] * (nozzle_from_sensor * point.in_sensor);
  }
  std::vector<Point3> onBed(const Eigen::Isometry3d& nozzle_from_sensor) const;
};

/// All points of the profiles at whose times the pose of the nozzle is known.
/// @throws InvalidInput if there are fewer than 100 points
ViewPoints viewPoints(const SensorRecording& recording, double time_offset_s);

/// At most `most` of the indices, evenly spread.
std::vector<std::size_t> evenlyChosen(const std::vector<std::size_t>& from, std::size_t most);

}  // namespace lamina
