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

/// Records the motion of a machine and what its sensor measures, from messages of a node or of a bag: poses
/// of the nozzle at each time stamp of tf, and profiles as clouds in their own frame. The memory for tf is
/// bounded; the memory for the recording is not.
class RecordingGatherer {
 public:
  /// @param bed, nozzle  names of the frames
  RecordingGatherer(std::string bed, std::string nozzle);

  void add(const geometry_msgs::TransformStamped& transform);
  /// Adds a transform that holds for all times.
  void addFixed(const geometry_msgs::TransformStamped& transform);
  void add(const sensor_msgs::PointCloud2& cloud);

  /// The recording so far, ascending in time.
  SensorRecording recording() const;

  /// Pose of the last cloud's frame at the nozzle, from tf [mm]; nothing if tf does not connect the two.
  std::optional<Eigen::Isometry3d> nozzleFromSensor() const;

  std::uint64_t malformed() const { return malformed_; }  ///< number of malformed clouds, left out
  /// Number of points that are not finite, left out.
  std::uint64_t pointsNotFinite() const { return points_not_finite_; }
  /// Number of time stamps of tf at which the pose of the nozzle is not known.
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
