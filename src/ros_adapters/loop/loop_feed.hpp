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
#include "tf/transform_sequence.hpp"

namespace lamina {

/// What became of clouds before the loop reads them: those received are the sum of what follows.
struct FeedCounts {
  std::uint64_t received = 0;
  std::uint64_t placed = 0;
  std::uint64_t waiting = 0;            ///< for tf
  std::uint64_t without_frame = 0;      ///< or without a stamp
  std::uint64_t malformed = 0;          ///< without the fields or bytes a cloud needs
  std::uint64_t without_transform = 0;  ///< older than what tf reported first
  std::uint64_t pushed_out = 0;         ///< of memory, or as ROS time went back, while waiting for tf
  std::uint64_t of_former_print = 0;
  std::string last_fault;  ///< what was wrong with the last malformed one
};

/// Gives one print after the other to the loop, from messages in the order in which they come: of a node, or
/// of a bag. The same for both, so that both give the same maps to the last bit. tf may be behind the clouds
/// by any time, and ahead of them by 30 s. Where ROS time goes back, the print goes on by the new time.
class LoopFeed {
 public:
  /// @param queue_mb  memory of the clouds that may wait for tf [1e6 bytes]
  LoopFeed(const LoopRunSettings& settings, double queue_mb);

  /// A toolpath begins a print, or is the plan that the loop offered last and goes on with the one under way
  /// (`LoopRun::follow`); what waits of the one before is left out.
  /// @return whether the print under way goes on
  /// @throws InvalidInput if the toolpath is none; there is no print then
  bool add(const lamina_msgs::Toolpath& toolpath);
  void add(const geometry_msgs::TransformStamped& transform, const std::string& authority);
  /// One that holds for all times.
  void addFixed(const geometry_msgs::TransformStamped& transform, const std::string& authority);
  void add(const sensor_msgs::PointCloud2ConstPtr& cloud);
  /// That a cloud of that stamp has come; to be said with the transforms that came with it. Of two clouds in
  /// turn the earlier stamp counts.
  void hear(const ros::Time& stamp);
  /// What a machine made of a map of the print under way, or of a plan of it.
  /// @return whether it is of that print
  bool add(const lamina_msgs::AppliedCorrection& applied);

  /// Of the print under way, from its next layer on, and of those that follow.
  /// @throws Rejected with the reason where the loop is blocked
  void request(LoopRequest request);

  /// The sensor was calibrated anew, for the print under way and those that follow; what is requested stays.
  void recalibrate(const LoopRunSettings& settings);

  /// Gives on what tf has come up to.
  void pass();
  /// The same, and nothing older comes.
  void passAll();
  /// The print is over: judges the layer under way if all of it is deposited.
  void finish();

  /// The print under way; none before the first toolpath.
  LoopRun* run() { return run_.get(); }
  const LoopRun* run() const { return run_.get(); }
  const FeedCounts& counts() const { return counts_; }
  /// As they are now.
  const LoopRunSettings& settings() const { return settings_; }

 private:
  using Cloud = sensor_msgs::PointCloud2ConstPtr;

  std::optional<ros::Time> takenAt(const ros::Time& stamp) const;
  std::string placedBy(const sensor_msgs::PointCloud2& cloud) const;
  bool place(const ros::Time& taken, const sensor_msgs::PointCloud2& cloud);
  void placeClouds();
  std::size_t framesToPlace() const;
  void pushOutOldest();
  void settle(const sensor_msgs::PointCloud2& cloud);
  std::size_t leaveOutWaiting();
  void followTime();

  LoopRunSettings settings_;
  double queue_bytes_;
  TransformSequence sequence_;
  std::multimap<ros::Time, Cloud> waiting_;        ///< by the time at which they were taken
  std::map<std::string, std::size_t> waiting_of_;  ///< number of those, by frame
  double waiting_bytes_ = 0.0;
  std::optional<ros::Time> heard_;         ///< to be reported once the transforms are passed on
  std::optional<ros::Time> heard_before_;  ///< of the last cloud
  std::uint64_t restarts_ = 0;             ///< of the sequence that the loop knows of
  std::unique_ptr<LoopRun> run_;
  FeedCounts counts_;
};

}  // namespace lamina
