// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tf/transform_lookup.hpp"

namespace lamina {

/// A pose of the nozzle over the bed at the time stamp of a transform.
struct StampedNozzle {
  ros::Time stamp;
  Eigen::Isometry3d bed_from_nozzle;  ///< translation [mm]
};

/// Stores transforms in the order of their time stamps, and passes them to a tf buffer only as far as
/// requested. Requests may lag behind tf by any time, whereas a tf buffer forgets transforms older than its
/// memory, and searches longer for older ones. Transforms may be added from another thread.
class TransformSequence {
 public:
  /// @param most_waiting  greatest number of transforms stored; beyond this, the oldest are passed to the
  ///   buffer without being asked for (`forced` counts them), and the buffer may then forget poses that are
  ///   asked for later
  explicit TransformSequence(std::size_t most_waiting = 500000);

  /// Adds a moving transform. A transform older than those in the buffer is passed to the buffer at the next
  /// call. If ROS time has gone back since the last transform, because a clock was set or a simulation was
  /// reset, everything begins anew; late transforms from before are dropped.
  ///
  /// A transform more than 30 s ahead of the last one of its child frame is kept back until the next
  /// transform of that frame. If the next one is not ahead, the stamp was garbled, and the transform kept
  /// back is dropped: the buffer would have forgotten the frame's other transforms, and refused later ones.
  void add(const geometry_msgs::TransformStamped& transform, const std::string& authority);
  /// Adds a transform that holds for all times.
  void addFixed(const geometry_msgs::TransformStamped& transform, const std::string& authority);

  /// Whether any transform names the frame.
  bool knows(const std::string& frame) const;

  /// Passes on the available transforms that are needed to know the pose of a frame over the bed at a time
  /// stamp.
  /// @return whether the pose is known now
  Readiness passTo(const std::string& frame, const ros::Time& stamp);
  /// Passes the transforms of the next time stamp to the buffer; returns false if there are none.
  bool passNext();

  const tf2::BufferCore& buffer() const { return buffer_; }
  /// Poses of the nozzle at the time stamps passed since the last call, ascending over all calls. Poses that
  /// depend on transforms still to come are returned later, unless the buffer has forgotten their time stamps
  /// by then; no pose is older than the last one returned.
  std::vector<StampedNozzle> takeNozzles();
  /// Number of time stamps passed whose pose was not returned yet; they span at most 30 s.
  std::size_t untaken() const;
  /// Number of transforms passed to the buffer without being asked for.
  std::uint64_t forced() const;
  /// Number of transforms received.
  std::uint64_t received() const;
  /// Number of times that ROS time has gone back; each time everything but transforms for all times is
  /// dropped.
  std::uint64_t restarts() const;

 private:
  struct Waiting {
    geometry_msgs::TransformStamped transform;
    std::string authority;
  };

  /// State of the stamps of a child frame.
  struct FrameClock {
    ros::Time latest;              ///< stamp; zero before the first
    std::optional<Waiting> ahead;  ///< kept back, more than 30 s ahead of `latest`
  };

  bool isOfTimeBefore(const ros::Time& stamp);
  void drop(const Waiting& ahead);
  std::vector<Waiting> believed(Waiting next);
  void keepFrames(const geometry_msgs::TransformStamped& transform);
  bool isNextUpTo(const ros::Time& stamp) const;
  void give(const Waiting& waiting);
  void notePassed(const ros::Time& stamp);

  std::size_t most_waiting_;
  tf2::BufferCore buffer_;
  mutable std::mutex mutex_;  ///< guards everything below
  std::multimap<ros::Time, Waiting> waiting_;
  std::map<std::string, FrameClock> clocks_;  ///< by child frame
  std::set<std::string> frames_;
  std::set<ros::Time> passed_;  ///< time stamps whose pose was not returned yet
  ros::Time taken_;             ///< last time stamp whose pose was returned
  ros::Time given_;             ///< last time stamp passed
  std::uint64_t received_ = 0;
  std::uint64_t forced_ = 0;
  std::uint64_t restarts_ = 0;
  ros::Time now_;        ///< ROS time at the last transform
  ros::Time went_back_;  ///< ROS time before it went back last
};

}  // namespace lamina
