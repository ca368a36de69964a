// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "lamina/control/run/loop_run.hpp"
#include "messages.hpp"
#include "tf/calibrated_frame.hpp"
#include "tf/transform_sequence.hpp"

namespace lamina {

/// Numbers of clouds by what happened to them before the loop reads them. Their sum is the number of clouds
/// received.
struct FeedCounts {
  std::uint64_t received = 0;
  std::uint64_t placed = 0;
  std::uint64_t waiting = 0;            ///< waiting for tf
  std::uint64_t without_frame = 0;      ///< without a frame or a time stamp
  std::uint64_t without_offset = 0;     ///< of a further sensor whose time offset is not stated
  std::uint64_t malformed = 0;          ///< without the fields or bytes that a cloud needs
  std::uint64_t without_transform = 0;  ///< older than the first transform from tf
  std::uint64_t pushed_out = 0;  ///< removed from memory while waiting for tf, or because ROS time went back
  std::uint64_t of_former_print = 0;
  std::string last_fault;           ///< fault of the last malformed cloud
  std::string last_without_offset;  ///< frame of the last cloud without a time offset
};

/// Counts from one time to another. Clouds that waited at the first time count as received: the sum holds for
/// these numbers too.
FeedCounts since(const FeedCounts& then, const FeedCounts& now);

/// Passes one print after the other to the loop, from messages in the order of arrival. A node and a bag
/// reader both use this class and give exactly the same maps. tf may be behind the clouds by any time, and
/// ahead of them by 30 s. If ROS time goes back, the print continues in the new time.
///
/// The calibrated pose of the sensor and its time offset hold for clouds of frame `names::kSensorFrame` or,
/// until one arrives, for clouds of the first frame. tf gives the poses of all other sensors; their time
/// offsets are stated by frame (`sensor.other_time_offsets_s`). Clouds without a stated offset are left out,
/// since they would be placed wrongly.
class LoopFeed {
 public:
  /// @param queue_mb  memory for clouds that wait for tf [1e6 bytes]
  /// @throws InvalidConfig as `otherTimeOffsets` and `timeOffsetSigmas`
  LoopFeed(const LoopRunSettings& settings, double queue_mb);

  /// Adds a toolpath. It begins a print, or is the plan that the loop offered last and continues the current
  /// print (`LoopRun::follow`). Clouds of an earlier print that still wait are dropped.
  /// @return whether the current print continues
  /// @throws InvalidInput if the toolpath is invalid; there is no print then
  bool add(const lamina_msgs::Toolpath& toolpath);
  void add(const geometry_msgs::TransformStamped& transform, const std::string& authority);
  /// Adds a transform that holds for all times.
  void addFixed(const geometry_msgs::TransformStamped& transform, const std::string& authority);
  void add(const sensor_msgs::PointCloud2ConstPtr& cloud);
  /// States that a cloud with this header has arrived; to be called together with the transforms that arrived
  /// with it. Of two successive clouds of a sensor the earlier stamp counts. Without effect for clouds that
  /// are left out for their frame, stamp or unknown time offset.
  void hear(const std_msgs::Header& header);
  /// Adds a machine's report on how it applied a map or a plan of the current print.
  /// @return whether the report belongs to the current print
  bool add(const lamina_msgs::AppliedCorrection& applied);

  /// Makes a request for the current print, from its next layer on, and for later prints.
  /// @throws Rejected with the reason if the loop is blocked
  void request(LoopRequest request);

  /// Sets new calibration data of the sensor for the current print and later ones; requests remain in force.
  void recalibrate(const LoopRunSettings& settings);

  /// Passes on the clouds for which tf is complete.
  void pass();
  /// Passes on the clouds for which tf is complete, given that no older transforms will arrive.
  void passAll();
  /// Ends the print: judges the current layer if all of it is deposited.
  void finish();

  /// The current print; null before the first toolpath.
  LoopRun* run() { return run_.get(); }
  const LoopRun* run() const { return run_.get(); }
  const FeedCounts& counts() const { return counts_; }
  /// The settings as changed by requests and calibrations.
  const LoopRunSettings& settings() const { return settings_; }

 private:
  using Cloud = sensor_msgs::PointCloud2ConstPtr;

  /// Times at which the arrived clouds of a sensor were taken.
  struct HeardSensor {
    std::optional<ros::Time> waiting;  ///< to be reported once the transforms are passed on
    std::optional<ros::Time> last;     ///< of the last cloud
  };

  std::optional<double> offsetOf(const std::string& frame);
  bool isCalibrated(const sensor_msgs::PointCloud2& cloud) const;
  std::string placedBy(const sensor_msgs::PointCloud2& cloud) const;
  bool place(const ros::Time& taken, const sensor_msgs::PointCloud2& cloud);
  void placeClouds();
  void pushOutOldest();
  void settle(const sensor_msgs::PointCloud2& cloud);
  std::size_t leaveOutWaiting();
  void followTime();

  LoopRunSettings settings_;
  double queue_bytes_;
  TransformSequence sequence_;
  std::multimap<ros::Time, Cloud> waiting_;  ///< by time stamp
  CalibratedFrame calibrated_frame_;
  std::map<std::string, double> other_offsets_s_;  ///< of further sensors, by frame
  std::map<std::string, std::size_t> waiting_of_;  ///< number of waiting clouds, by frame
  double waiting_bytes_ = 0.0;
  std::map<std::string, HeardSensor> heard_;  ///< during the print, by frame
  std::uint64_t restarts_ = 0;                ///< number of restarts of the sequence that the loop knows of
  std::unique_ptr<LoopRun> run_;
  FeedCounts counts_;
};

}  // namespace lamina
