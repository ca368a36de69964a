// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "profile_intake.hpp"

#include "lamina/base/error.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "transforms.hpp"

namespace lamina {
namespace {

constexpr double kRemembered = 30.0;  // s of transforms
constexpr double kTurn = 0.02;        // s between looks at what is due

}  // namespace

ProfileIntake::ProfileIntake(ros::NodeHandle node, int queue, Receiver receiver)
    : buffer_(ros::Duration(kRemembered)),
      transforms_(buffer_, node),
      queue_(static_cast<std::size_t>(queue)),
      receiver_(std::move(receiver)) {
  timer_ = node.createWallTimer(ros::WallDuration(kTurn), [this](const ros::WallTimerEvent&) { passDue(); });
  const boost::function<void(const CloudEvent&)> onMessage = [this](const CloudEvent& event) {
    onCloud(event);
  };
  subscriber_ = node.subscribe<sensor_msgs::PointCloud2>(names::kProfile, static_cast<std::uint32_t>(queue),
                                                         onMessage, {}, ros::TransportHints().tcpNoDelay());
}

IntakeCounts ProfileIntake::counts() const {
  IntakeCounts counts = counts_;
  counts.waiting =
      counts_.received - counts_.without_frame - counts_.untransformable - counts_.malformed - counts_.placed;
  return counts;
}

void ProfileIntake::onCloud(const CloudEvent& event) {
  ++counts_.received;
  countLost(event);
  if (event.getMessage()->header.frame_id.empty())
    ++counts_.without_frame;
  else
    wait(event.getMessage());
}

void ProfileIntake::countLost(const CloudEvent& event) {
  const std::uint32_t sequence = event.getMessage()->header.seq;
  const auto [last, is_first] = last_sequence_.insert({event.getPublisherName(), sequence});
  if (!is_first && sequence > last->second) counts_.lost += sequence - last->second - 1;
  last->second = sequence;
}

void ProfileIntake::wait(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  auto& clouds = waiting_[cloud->header.frame_id];
  clouds.insert({cloud->header.stamp, cloud});
  if (clouds.size() <= queue_) return;
  clouds.erase(clouds.begin());
  ++counts_.untransformable;
}

void ProfileIntake::passDue() {
  for (auto& [frame, clouds] : waiting_) {
    while (!clouds.empty()) {
      const auto cloud = clouds.begin()->second;
      const Readiness ready = readiness(buffer_, names::kBedFrame, frame, cloud->header.stamp);
      if (ready == Readiness::NotYet) break;
      clouds.erase(clouds.begin());
      if (ready == Readiness::Ready)
        place(*cloud);
      else
        ++counts_.untransformable;
    }
  }
}

void ProfileIntake::place(const sensor_msgs::PointCloud2& cloud) {
  const ros::Time stamp = cloud.header.stamp;
  const auto bed_from_cloud = lookUp(buffer_, names::kBedFrame, cloud.header.frame_id, stamp);
  if (!bed_from_cloud) {
    ++counts_.untransformable;
    return;
  }
  const auto bed_from_nozzle = lookUp(buffer_, names::kBedFrame, names::kNozzleFrame, stamp);
  PlacedProfile profile;
  if (bed_from_nozzle) profile.nozzle_height_mm = bed_from_nozzle->translation().z();
  try {
    CloudPoints read = fromMessage(cloud, *bed_from_cloud);
    counts_.points_not_finite += read.not_finite;
    profile.points = std::move(read.points);
  } catch (const InvalidInput& error) {
    ++counts_.malformed;
    counts_.last_fault = error.what();
    return;
  }
  ++counts_.placed;
  if (!bed_from_nozzle) ++counts_.without_nozzle;
  receiver_(profile);
}

}  // namespace lamina
