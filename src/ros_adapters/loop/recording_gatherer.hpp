// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "lamina/calibration/sensor_recording.hpp"

namespace lamina {

/// A machine that moves and what its sensor sees, from messages of a node or of a bag: poses of the nozzle at
/// each stamp reported on tf, and profiles as clouds in their own frame. Memory for tf is bounded; that
/// of the recording is not.
class RecordingGatherer {
 public:
  /// @param bed, nozzle  frames
  RecordingGatherer(std::string bed, std::string nozzle);

  void add(const geometry_msgs::TransformStamped& transform);
  /// One that holds for all times.
  void addFixed(const geometry_msgs::TransformStamped& transform);
  void add(const sensor_msgs::PointCloud2& cloud);

  /// What came so far, ascending in time.
  SensorRecording recording() const;

  /// Where tf has the frame of the last cloud at the nozzle [mm]; nothing if it does not connect them.
  std::optional<Eigen::Isometry3d> nozzleFromSensor() const;

  std::uint64_t malformed() const { return malformed_; }                ///< clouds, left out
  std::uint64_t pointsNotFinite() const { return points_not_finite_; }  ///< left out
  /// Of tf, at which it does not place the nozzle.
  std::uint64_t stampsWithoutPose() const { return given_up_ + waiting_.size(); }

 private:
  void settle();

  std::string bed_;
  std::string nozzle_;
  std::string sensor_;  ///< frame of the last cloud
  tf2::BufferCore buffer_;
  std::set<ros::Time> waiting_;
  std::map<ros::Time, Eigen::Isometry3d> placed_;
  ros::Time latest_;
  std::vector<RecordedProfile> profiles_;
  std::uint64_t given_up_ = 0;
  std::uint64_t malformed_ = 0;
  std::uint64_t points_not_finite_ = 0;
};

}  // namespace lamina
