// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "tf/transforms.hpp"

namespace lamina {

/// A pose of the nozzle over the bed at the stamp of a transform.
struct StampedNozzle {
  ros::Time stamp;
  Eigen::Isometry3d bed_from_nozzle;  ///< translation [mm]
};

/// Keeps transforms in the order of their stamps and gives them to a tf buffer no further than is asked for.
/// So how far what is asked for lags behind tf does not matter: a tf buffer forgets what is older than its
/// memory, and takes the longer the further back it has to look. Transforms may come on another thread.
class TransformSequence {
 public:
  /// @param most_waiting  transforms; beyond this, the oldest go to the buffer unasked, which may then forget
  ///   the poses of frames that are asked for later; `forced` counts them
  explicit TransformSequence(std::size_t most_waiting = 500000);

  /// A transform that moves. One that is older than what the buffer was given goes there at the next call.
  /// Begins anew if ROS time has gone back since the last one, by a clock that was set or a simulation that
  /// was reset; what was stamped before that and comes late is left out.
  void add(const geometry_msgs::TransformStamped& transform, const std::string& authority);
  /// One that holds for all times.
  void addFixed(const geometry_msgs::TransformStamped& transform, const std::string& authority);

  /// Whether any transform names the frame.
  bool knows(const std::string& frame) const;

  /// Whether the pose of a frame over the bed is known at that stamp, after as many transforms have been
  /// given to the buffer as that needs, and there are.
  Readiness passTo(const std::string& frame, const ros::Time& stamp);
  /// Gives the transforms of the next stamp to the buffer. False if there are none.
  bool passNext();

  const tf2::BufferCore& buffer() const { return buffer_; }
  /// Poses of the nozzle at the stamps passed since the last call, ascending over all calls. Those that
  /// depend on transforms still to come wait, until the buffer has forgotten their stamps; none is given of a
  /// stamp older than the last.
  std::vector<StampedNozzle> takeNozzles();
  /// Stamps passed of which the pose was not taken yet: of 30 s at most.
  std::size_t untaken() const;
  /// Transforms that went to the buffer unasked so far.
  std::uint64_t forced() const;
  /// Transforms received so far.
  std::uint64_t received() const;
  /// How often ROS time has gone back so far, which leaves nothing of before but what holds for all times.
  std::uint64_t restarts() const;

 private:
  struct Waiting {
    geometry_msgs::TransformStamped transform;
    std::string authority;
  };

  bool isOfTimeBefore(const ros::Time& stamp);
  void keepFrames(const geometry_msgs::TransformStamped& transform);
  bool isNextUpTo(const ros::Time& stamp) const;
  void give(const Waiting& waiting);
  void notePassed(const ros::Time& stamp);

  std::size_t most_waiting_;
  tf2::BufferCore buffer_;
  mutable std::mutex mutex_;  ///< of what follows
  std::multimap<ros::Time, Waiting> waiting_;
  std::set<std::string> frames_;
  std::set<ros::Time> passed_;  ///< stamps of which the nozzle's pose was not taken
  ros::Time taken_;             ///< the last stamp of which it was
  ros::Time given_;             ///< the last stamp passed
  std::uint64_t received_ = 0;
  std::uint64_t forced_ = 0;
  std::uint64_t restarts_ = 0;
  ros::Time now_;        ///< ROS time at the last transform
  ros::Time went_back_;  ///< ROS time from which it went back last
};

}  // namespace lamina
