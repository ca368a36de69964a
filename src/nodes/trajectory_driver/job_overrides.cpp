// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job_overrides.hpp"

#include <ros/ros.h>

#include <utility>

#include "lamina/streaming/job/live_change.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "status.hpp"

namespace lamina {
namespace {

/// @throws InvalidInput if a robot's job has no such setting
OverrideKind overrideOf(const std::string& setting) {
  for (const OverrideKind kind : {OverrideKind::Feed, OverrideKind::Flow, OverrideKind::Power})
    if (setting == nameOf(kind)) return kind;
  throw InvalidInput("'" + setting +
                     "' cannot be changed while a toolpath is driven; expected feed, flow or power");
}

}  // namespace

JobOverrides::JobOverrides(ros::NodeHandle& node, const TrajectoryFeederSettings& settings,
                           const ExecutorOwner& owner, std::function<std::shared_ptr<DriveSession>()> session)
    : settings_(settings), owner_(owner), session_(std::move(session)) {
  const boost::function<void(const ros::MessageEvent<const std_msgs::Float64>&)> on_speed =
      [this](const auto& event) { onSpeedFactor(event); };
  speed_ = node.subscribe<std_msgs::Float64>(names::kSpeedFactor, 10, on_speed);
  const boost::function<bool(Change&)> on_change = [this](Change& event) { return onChange(event); };
  ros::AdvertiseServiceOptions options;
  options.initBySpecType<Change>(names::kChangeJob, on_change);
  service_ = node.advertiseService(options);
}

void JobOverrides::applyTo(DriveSession& session) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [kind, share] : shares_) {
    ROS_WARN("%s is %.4g of what is planned, as it was set before", nameOf(kind), share);
    try {
      session.setShare(kind, share);
    } catch (const InvalidInput& refused) {
      ROS_WARN("%s stays as planned: %s", nameOf(kind), refused.what());
    }
  }
}

bool JobOverrides::onChange(Change& event) {
  const std::string setting = event.getRequest().setting;
  try {
    const std::string refusal = owner_.refusal(event.getCallerName());
    if (!refusal.empty()) throw Rejected(refusal);
    change(setting, event.getRequest().value);
  } catch (const Error&) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"change", setting, ""}, failure));
    event.getResponse().status = toMessage(failure);
  }
  return true;
}

void JobOverrides::change(const std::string& setting, double share) {
  const OverrideKind kind = overrideOf(setting);
  const auto job = session_();
  const TrajectoryFeederSettings& feeding = job ? job->feeding() : settings_;
  OverrideBounds bounds = boundsOf(kind);
  if (kind == OverrideKind::Feed) bounds.most = feeding.feed_most;
  std::string refusal = overrideRefusal(kind, share, bounds);
  if (kind == OverrideKind::Feed && share > bounds.most) refusal = speedRefusal(share, feeding);
  if (!refusal.empty()) throw InvalidInput(refusal);
  if (!job || !job->isChangeable()) throw Rejected(kNoJobToChange);
  const bool stands = job->setShare(kind, share);
  if (stands && !job->isDry()) keep(kind, share);
}

void JobOverrides::onSpeedFactor(const ros::MessageEvent<const std_msgs::Float64>& event) {
  const double share = event.getConstMessage()->data;
  const auto job = session_();
  std::string refusal = owner_.refusal(event.getPublisherName());
  if (refusal.empty()) refusal = speedRefusal(share, job ? job->feeding() : settings_);
  if (!refusal.empty()) {
    ROS_WARN("a speed factor is not used: %s", refusal.c_str());
    return;
  }
  const bool stands = !job || job->setShare(OverrideKind::Feed, share);
  if (stands && (!job || !job->isDry())) keep(OverrideKind::Feed, share);
}

void JobOverrides::keep(OverrideKind kind, double share) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shares_.erase(kind);
  if (share != 1.0) shares_[kind] = share;
  ROS_INFO("going on with %s at %.4g of what is planned", nameOf(kind), share);
}

}  // namespace lamina
