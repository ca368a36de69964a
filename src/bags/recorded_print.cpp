// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_print.hpp"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <deque>
#include <fstream>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr double kQueueMb = 400.0;
constexpr double kBehind =
    2.0;  // s of the recording, by which tf may be recorded before clouds of its stamps

/// As rosbag plays them: a topic without a slash is below the root.
std::string rooted(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic : "/" + topic;
}

class PrintReader {
 public:
  PrintReader(const std::string& space, const LoopRunSettings& settings, const PrintReceivers& receivers)
      : toolpath_(inSpace(space, names::kToolpath)),
        profile_(inSpace(space, names::kProfile)),
        applied_(inSpace(space, names::kAppliedCorrection)),
        feed_(settings, kQueueMb),
        receivers_(receivers) {}

  void read(const rosbag::MessageInstance& message) {
    const std::string topic = rooted(message.getTopic());
    const ros::Time recorded = message.getTime();
    if (topic == toolpath_)
      begin(message);
    else if (topic == profile_)
      add(message.instantiate<sensor_msgs::PointCloud2>(), recorded);
    else if (topic == applied_)
      behind_.emplace_back(recorded,
                           Late{nullptr, {}, message.instantiate<lamina_msgs::AppliedCorrection>()});
    else if (topic == "/tf")
      behind_.emplace_back(recorded, Late{message.instantiate<tf2_msgs::TFMessage>(), {}, nullptr});
    else if (topic == "/tf_static")
      addFixed(message.instantiate<tf2_msgs::TFMessage>());
    else
      return;
    release(recorded - ros::Duration(kBehind));
  }

  void end() {
    release(ros::TIME_MAX);
    finish();
  }

 private:
  /// What is used later than it was recorded: transforms, what the machine applied, or that a cloud has come.
  struct Late {
    tf2_msgs::TFMessageConstPtr transforms;
    std_msgs::Header heard;
    lamina_msgs::AppliedCorrectionConstPtr applied;
  };

  static std::string inSpace(const std::string& space, const char* name) {
    const std::string root = space.empty() || space == "/" ? "" : rooted(space);
    return root + "/" + name;
  }

  void begin(const rosbag::MessageInstance& message) {
    const auto toolpath = message.instantiate<lamina_msgs::Toolpath>();
    if (!toolpath) return;
    end();
    feed_.add(*toolpath);
    receivers_.begins(*feed_.run());
    tell();
  }

  void add(const sensor_msgs::PointCloud2ConstPtr& cloud, const ros::Time& recorded) {
    if (!cloud) return;
    feed_.add(cloud);
    behind_.emplace_back(recorded, Late{nullptr, cloud->header, nullptr});
  }

  void addFixed(const tf2_msgs::TFMessageConstPtr& message) {
    if (!message) return;
    for (const auto& transform : message->transforms) feed_.addFixed(transform, "bag");
  }

  void release(const ros::Time& until) {
    bool is_new = false;
    for (; !behind_.empty() && behind_.front().first <= until; behind_.pop_front()) {
      const Late& late = behind_.front().second;
      if (late.applied) {
        note(*late.applied);
        continue;
      }
      if (!late.transforms) {
        feed_.hear(late.heard);
        continue;
      }
      for (const auto& transform : late.transforms->transforms) feed_.add(transform, "bag");
      is_new = true;
    }
    if (!is_new) return;
    feed_.pass();
    tell();
  }

  /// By what came before it, as the node does.
  void note(const lamina_msgs::AppliedCorrection& applied) {
    feed_.pass();
    feed_.add(applied);
    tell();
  }

  void finish() {
    if (feed_.run() == nullptr) return;
    feed_.finish();
    tell();
    receivers_.ends(*feed_.run(), since(before_, feed_.counts()));
    before_ = feed_.counts();
  }

  void tell() {
    if (feed_.run() != nullptr) receivers_.news(*feed_.run(), feed_.run()->takeNews());
  }

  std::string toolpath_;
  std::string profile_;
  std::string applied_;
  LoopFeed feed_;
  FeedCounts before_;  ///< at the end of the print before
  PrintReceivers receivers_;
  std::deque<std::pair<ros::Time, Late>> behind_;
};

}  // namespace

BagFigures runRecordedPrints(const std::string& path, const std::string& space,
                             const LoopRunSettings& settings, const PrintReceivers& receivers) {
  BagFigures figures;
  requireReadable(path);
  try {
    rosbag::Bag bag(path, rosbag::bagmode::Read);
    rosbag::View view(bag);
    PrintReader reader(space, settings, receivers);
    for (const rosbag::MessageInstance& message : view) {
      reader.read(message);
      ++figures.messages;
    }
    reader.end();
    if (figures.messages > 0) figures.recorded_s = (view.getEndTime() - view.getBeginTime()).toSec();
  } catch (const rosbag::BagException&) {
    // Its own messages quote what stands in the file.
    throw FileError("cannot read '" + path +
                    "': it is no ROS bag, or one that was cut off; expected a whole one");
  } catch (const ros::serialization::StreamOverrunException&) {
    throw FileError("cannot read '" + path + "': a message ends too early; expected a whole bag");
  }
  return figures;
}

}  // namespace lamina
