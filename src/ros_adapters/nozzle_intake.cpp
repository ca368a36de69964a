// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nozzle_intake.hpp"

#include <utility>

#include "names.hpp"
#include "transforms.hpp"

namespace lamina {
namespace {

constexpr double kRemembered = 30.0;         // s of transforms
constexpr double kTurn = 0.02;               // s between looks at what is due
constexpr std::size_t kNozzleBurst = 20000;  // messages, as `TransformIntake`

}  // namespace

NozzleIntake::NozzleIntake(ros::NodeHandle node, Receiver receiver)
    : buffer_(ros::Duration(kRemembered)), transforms_(buffer_, node), receiver_(std::move(receiver)) {
  const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> onMessage =
      [this](const tf2_msgs::TFMessageConstPtr& message) { onTransforms(*message); };
  subscriber_ = node.subscribe<tf2_msgs::TFMessage>("/tf", kNozzleBurst, onMessage, {},
                                                    ros::TransportHints().tcpNoDelay());
  timer_ = node.createWallTimer(ros::WallDuration(kTurn), [this](const ros::WallTimerEvent&) { passDue(); });
}

void NozzleIntake::onTransforms(const tf2_msgs::TFMessage& message) {
  for (const auto& transform : message.transforms)
    if (transform.header.stamp > passed_) waiting_.insert(transform.header.stamp);
  if (waiting_.size() > kNozzleBurst) waiting_.erase(waiting_.begin());
}

void NozzleIntake::passDue() {
  while (!waiting_.empty()) {
    const ros::Time stamp = *waiting_.begin();
    const Readiness ready = readiness(buffer_, names::kBedFrame, names::kNozzleFrame, stamp);
    if (ready == Readiness::NotYet) return;
    waiting_.erase(waiting_.begin());
    passed_ = stamp;
    if (ready == Readiness::Never) continue;
    const auto bed_from_nozzle = lookUp(buffer_, names::kBedFrame, names::kNozzleFrame, stamp);
    if (bed_from_nozzle) receiver_(*bed_from_nozzle);
  }
}

}  // namespace lamina
