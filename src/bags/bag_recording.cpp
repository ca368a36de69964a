// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_recording.hpp"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "lamina/base/error.hpp"
#include "point_cloud.hpp"
#include "transforms.hpp"

namespace lamina {
namespace {

constexpr double kKeptS = 60.0;    // of tf, behind the latest transform
constexpr double kWaitedS = 30.0;  // for the other transforms of a stamp

bool isNamed(const std::string& topic, const std::string& name) {
  if (topic == name) return true;
  return topic.size() > name.size() && topic.compare(topic.size() - name.size(), name.size(), name) == 0 &&
         topic[topic.size() - name.size() - 1] == '/';
}

/// Gathers poses of the nozzle while transforms come.
class PoseGatherer {
 public:
  explicit PoseGatherer(const BagNames& names) : names_(names), buffer_(ros::Duration(kKeptS)) {}

  void add(const tf2_msgs::TFMessage& message, bool is_static) {
    for (const auto& transform : message.transforms) {
      buffer_.setTransform(transform, "bag", is_static);
      if (is_static) continue;
      waiting_.insert(transform.header.stamp);
      latest_ = std::max(latest_, transform.header.stamp);
    }
    settle();
  }

  /// Those that were placed, by time.
  std::vector<RecordedPose> poses() const {
    std::vector<RecordedPose> poses;
    for (const auto& [stamp, pose] : placed_) poses.push_back({stamp.toSec(), pose});
    return poses;
  }
  std::uint64_t withoutPose() const { return given_up_ + waiting_.size(); }

 private:
  void settle() {
    while (!waiting_.empty()) {
      const ros::Time stamp = *waiting_.begin();
      const auto pose = lookUp(buffer_, names_.bed, names_.nozzle, stamp);
      if (!pose && (latest_ - stamp).toSec() < kWaitedS) return;
      if (pose) placed_.emplace(stamp, *pose);
      if (!pose) ++given_up_;
      waiting_.erase(waiting_.begin());
    }
  }

  BagNames names_;
  tf2::BufferCore buffer_;
  std::set<ros::Time> waiting_;
  std::map<ros::Time, Eigen::Isometry3d> placed_;
  ros::Time latest_;
  std::uint64_t given_up_ = 0;
};

void addCloud(BagRecording& read, const sensor_msgs::PointCloud2& cloud) {
  try {
    CloudPoints points = fromMessage(cloud, Eigen::Isometry3d::Identity());
    read.points_not_finite += points.not_finite;
    if (!points.points.empty())
      read.recording.profiles.push_back({cloud.header.stamp.toSec(), std::move(points.points)});
  } catch (const InvalidInput&) {
    ++read.malformed;
  }
}

void addMessages(BagRecording& read, const std::string& path, const BagNames& names) {
  PoseGatherer poses(names);
  const rosbag::Bag bag(path);
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    const bool is_static = isNamed(message.getTopic(), "tf_static");
    if (is_static || isNamed(message.getTopic(), "tf")) {
      if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>())
        poses.add(*transforms, is_static);
    } else if (isNamed(message.getTopic(), names.profile)) {
      if (const auto cloud = message.instantiate<sensor_msgs::PointCloud2>()) addCloud(read, *cloud);
    }
  }
  read.recording.poses = poses.poses();
  read.stamps_without_pose = poses.withoutPose();
}

}  // namespace

BagRecording readBagRecording(const std::string& path, const BagNames& names) {
  BagRecording read;
  try {
    addMessages(read, path, names);
  } catch (const rosbag::BagException& error) {
    throw FileError("'" + path + "' cannot be read as a bag: " + error.what());
  }
  auto& profiles = read.recording.profiles;
  std::stable_sort(profiles.begin(), profiles.end(),
                   [](const RecordedProfile& a, const RecordedProfile& b) { return a.time_s < b.time_s; });
  if (read.recording.poses.size() < 2 || profiles.empty())
    throw InvalidInput("'" + path + "' holds " + std::to_string(read.recording.poses.size()) + " poses of '" +
                       names.nozzle + "' in '" + names.bed + "' and " + std::to_string(profiles.size()) +
                       " clouds on '" + names.profile + "'; expected two and one");
  return read;
}

}  // namespace lamina
