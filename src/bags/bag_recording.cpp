// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_recording.hpp"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "loop/recording_gatherer.hpp"

namespace lamina {
namespace {

bool isNamed(const std::string& topic, const std::string& name) {
  if (topic == name) return true;
  return topic.size() > name.size() && topic.compare(topic.size() - name.size(), name.size(), name) == 0 &&
         topic[topic.size() - name.size() - 1] == '/';
}

void addMessages(BagRecording& read, const std::string& path, const BagNames& names) {
  RecordingGatherer gathered(names.bed, names.nozzle);
  requireReadable(path);
  const rosbag::Bag bag(path);
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    const bool is_static = isNamed(message.getTopic(), "tf_static");
    if (is_static || isNamed(message.getTopic(), "tf")) {
      const auto stated = message.instantiate<tf2_msgs::TFMessage>();
      if (!stated) continue;
      for (const auto& transform : stated->transforms)
        is_static ? gathered.addFixed(transform) : gathered.add(transform);
    } else if (isNamed(message.getTopic(), names.profile)) {
      if (const auto cloud = message.instantiate<sensor_msgs::PointCloud2>()) gathered.add(*cloud);
    }
  }
  read.recording = gathered.recording();
  read.malformed = gathered.malformed();
  read.points_not_finite = gathered.pointsNotFinite();
  read.stamps_without_pose = gathered.stampsWithoutPose();
}

}  // namespace

BagRecording readBagRecording(const std::string& path, const BagNames& names) {
  BagRecording read;
  try {
    addMessages(read, path, names);
  } catch (const rosbag::BagException& error) {
    throw FileError("'" + path + "' cannot be read as a bag: " + error.what());
  }
  const auto& profiles = read.recording.profiles;
  if (read.recording.poses.size() < 2 || profiles.empty())
    throw InvalidInput("'" + path + "' holds " + std::to_string(read.recording.poses.size()) + " poses of '" +
                       names.nozzle + "' in '" + names.bed + "' and " + std::to_string(profiles.size()) +
                       " clouds on '" + names.profile + "'; expected two and one");
  return read;
}

}  // namespace lamina
