// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop/recording_gatherer.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/error.hpp"
#include "point_cloud.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina {
namespace {

constexpr double kKeptS = 60.0;    // of tf, behind the latest transform
constexpr double kWaitedS = 30.0;  // for the other transforms of a stamp
const char kRecording[] = "recording";

}  // namespace

RecordingGatherer::RecordingGatherer(std::string bed, std::string nozzle)
    : bed_(std::move(bed)), nozzle_(std::move(nozzle)), buffer_(ros::Duration(kKeptS)) {}

void RecordingGatherer::add(const geometry_msgs::TransformStamped& transform) {
  buffer_.setTransform(transform, kRecording, false);
  waiting_.insert(transform.header.stamp);
  latest_ = std::max(latest_, transform.header.stamp);
  settle();
}

void RecordingGatherer::addFixed(const geometry_msgs::TransformStamped& transform) {
  buffer_.setTransform(transform, kRecording, true);
  settle();
}

void RecordingGatherer::add(const sensor_msgs::PointCloud2& cloud) {
  sensor_ = cloud.header.frame_id;
  try {
    CloudPoints points = fromMessage(cloud, Eigen::Isometry3d::Identity());
    points_not_finite_ += points.not_finite;
    if (!points.points.empty()) profiles_.push_back({cloud.header.stamp.toSec(), std::move(points.points)});
  } catch (const InvalidInput&) {
    ++malformed_;
  }
}

void RecordingGatherer::settle() {
  while (!waiting_.empty()) {
    const ros::Time stamp = *waiting_.begin();
    const auto pose = lookUp(buffer_, bed_, nozzle_, stamp);
    if (!pose && (latest_ - stamp).toSec() < kWaitedS) return;
    if (pose) placed_.emplace(stamp, *pose);
    if (!pose) ++given_up_;
    waiting_.erase(waiting_.begin());
  }
}

SensorRecording RecordingGatherer::recording() const {
  SensorRecording recording;
  for (const auto& [stamp, pose] : placed_) recording.poses.push_back({stamp.toSec(), pose});
  recording.profiles = profiles_;
  std::stable_sort(recording.profiles.begin(), recording.profiles.end(),
                   [](const RecordedProfile& a, const RecordedProfile& b) { return a.time_s < b.time_s; });
  return recording;
}

std::optional<Eigen::Isometry3d> RecordingGatherer::nozzleFromSensor() const {
  if (sensor_.empty()) return std::nullopt;
  return lookUp(buffer_, nozzle_, sensor_, ros::Time(0));
}

}  // namespace lamina
