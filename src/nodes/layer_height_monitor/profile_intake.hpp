// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cloud_stamps.hpp"
#include "lamina/geometry/vector.hpp"
#include "tf/calibrated_frame.hpp"
#include "tf/transform_intake.hpp"
#include "tf/transform_sequence.hpp"

namespace lamina {

/// A profile with the position and the time at which it was taken.
struct PlacedProfile {
  ros::Time stamp;
  std::vector<Point3> points;  ///< [mm, bed frame]
};

/// Time offset and pose of the sensor of the calibrated frame (`CalibratedFrame`), and time offsets of other
/// sensors. Sensors without a stated offset have the offset 0; tf has the poses of all other sensors.
struct CalibratedSensor {
  double time_offset_s = 0.0;                           ///< true time is the stamp less this
  std::map<std::string, double> other_time_offsets_s;   ///< offsets of others, by the frame of their clouds
  std::optional<Eigen::Isometry3d> nozzle_from_sensor;  ///< [mm]; nothing: the pose of tf
};

/// A number of clouds and of their points.
struct CloudTally {
  std::uint64_t clouds = 0;
  std::uint64_t points = 0;

  void add(const sensor_msgs::PointCloud2& cloud) {
    ++clouds;
    points += std::uint64_t{cloud.width} * cloud.height;
  }
};

/// Outcome of clouds and of their points: the number received is the sum of those placed, those waiting and
/// those that could not be used.
struct IntakeCounts {
  CloudTally received;
  CloudTally placed;
  CloudTally waiting;                   ///< for tf
  CloudTally without_frame;             ///< without a frame or a stamp
  CloudTally malformed;                 ///< without the fields or bytes a cloud needs
  CloudTally without_transform;         ///< older than the first transform of tf
  CloudTally without_nozzle;            ///< tf places the cloud, but not the nozzle
  CloudTally pushed_out;                ///< removed while waiting for tf, also as ROS time went back
  CloudTally of_former_print;           ///< still waiting when the next toolpath came
  std::uint64_t waiting_bytes = 0;      ///< memory of the waiting clouds
  std::uint64_t lost = 0;               ///< missing in the publisher's sequence; not received
  std::uint64_t points_not_finite = 0;  ///< of those placed
  std::uint64_t transforms_forced = 0;  ///< passed on before their turn, since too many waited for clouds
  std::string last_fault;               ///< fault of the last malformed cloud
};

/// Receives profiles and places each on the bed by tf at its own stamp, however late tf is. Profiles and
/// poses of the nozzle are each passed on in the order of their stamps; a profile follows the first pose that
/// is not older. (tf2_ros::MessageFilter is no choice: with thousands of clouds waiting it crashes in
/// BufferCore::testTransformableRequests, and it releases clouds in any order.)
class ProfileIntake {
 public:
  struct Receivers {
    std::function<void(const PlacedProfile&)> profile;
    std::function<void(const StampedNozzle&)> nozzle;
    std::function<void()> restarted;  ///< ROS time went back: the stamps that follow are of the new time
  };

  /// Subscribes to `profile` and to tf.
  /// @param queue_mb  memory of the clouds that may wait for tf [1e6 bytes]
  /// @param sensor    as calibrated; stamps that are zero, or before 1970 after its correction, count as
  ///   without frame
  ProfileIntake(ros::NodeHandle node, double queue_mb, CalibratedSensor sensor, Receivers receivers);

  IntakeCounts counts() const;
  /// Whether profiles and tf have publishers.
  bool isConnected() const { return subscriber_.getNumPublishers() > 0 && transforms_.isConnected(); }

  /// Whether tf has reached `position` and profiles have reached `profile` (`CloudStamps`), and all clouds
  /// that these transforms place are processed. Zero stamps require no more than has arrived.
  bool hasCome(const ros::Time& position, const ros::Time& profile);

  /// Leaves out, and counts, data of a print that is over: waiting clouds, and received poses of the nozzle
  /// that were not passed on.
  void startOver();

  /// Changes with every cloud that arrives or is placed and, while clouds wait, with every transform.
  std::uint64_t news() const {
    const std::uint64_t transforms = counts_.waiting.clouds > 0 ? sequence_.received() : 0;
    return counts_.received.clouds + counts_.placed.clouds + transforms;
  }

 private:
  using Cloud = sensor_msgs::PointCloud2ConstPtr;
  using CloudEvent = ros::MessageEvent<sensor_msgs::PointCloud2 const>;
  using Clouds = std::multimap<ros::Time, Cloud>;

  void onCloud(const CloudEvent& event);
  Cloud taken(const Cloud& cloud);
  double offsetOf(const std::string& frame);
  std::string placedBy(const std::string& frame) const;
  bool isHeldUp(const ros::Time& until) const;
  void leaveOutWaiting(CloudTally& as);
  void followTime();
  void countLost(const CloudEvent& event);
  void wait(const Cloud& cloud);
  bool isTooFull() const;
  void pushOutOldest();
  void passDue();
  /// The frame of the oldest cloud among the frames that tf names; empty if there is none.
  std::string nextFrame(const std::set<std::string>& passed_over) const;
  bool passFirst(const std::string& frame);
  void addNozzles();
  void place(const sensor_msgs::PointCloud2& cloud);
  void settle(const sensor_msgs::PointCloud2& cloud, CloudTally& as);

  TransformSequence sequence_;
  TransformIntake transforms_;
  double queue_bytes_;
  CalibratedSensor sensor_;
  CalibratedFrame calibrated_frame_;
  Receivers receivers_;
  std::map<std::string, Clouds> waiting_;  ///< by frame
  IntakeCounts counts_;
  CloudStamps stamps_;                                  ///< of all clouds received
  std::uint64_t restarts_ = 0;                          ///< of the sequence that the receivers know of
  std::map<std::string, std::uint32_t> last_sequence_;  ///< by publisher
  ros::WallTimer timer_;
  ros::Subscriber subscriber_;
};

}  // namespace lamina
