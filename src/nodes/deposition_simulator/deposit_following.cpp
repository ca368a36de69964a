// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "deposit_following.hpp"

#include "conversions.hpp"
#include "deposit_messages.hpp"
#include "lamina/base/error.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "latched.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr double kShare = 0.05;        // of the toolpath, after which all is published whatever the time
constexpr std::uint32_t kNoBound = 0;  // of a queue: states are small, and as many as periods and shares
constexpr std::uint32_t kClouds = 1 / kShare;  // that may wait for a slow subscriber

}  // namespace

DepositFollowing::DepositFollowing(ros::NodeHandle node, const DepositionSimulatorSettings& settings)
    : settings_(settings),
      deposited_(node.advertise<sensor_msgs::PointCloud2>(names::kDeposited, kClouds, true)),
      markers_(node.advertise<visualization_msgs::MarkerArray>(names::kDepositedMarkers, 1, true)),
      state_(node.advertise<lamina_msgs::DepositionState>(names::kDepositionState, kNoBound, true)),
      intake_(node,
              [this](const Eigen::Isometry3d& bed_from_nozzle) {
                if (followed_) follow(bed_from_nozzle.translation());
              }),
      timer_(node.createWallTimer(ros::WallDuration(settings.period_s),
                                  [this](const ros::WallTimerEvent&) { publish(); })) {}

void DepositFollowing::begin(const lamina_msgs::Toolpath& message) {
  followed_.reset();
  toolpath_id_ = message.id;
  published_mm3_ = 0.0;
  cloud_mm3_ = markers_mm3_ = kNotPublished;
  try {
    const MachineToolpath read = fromMessage(message);
    followed_ = std::make_unique<FollowedDeposit>(placed(read.toolpath, read.bed_from_part),
                                                  settings_.simulation.deposition, settings_.following);
    ROS_INFO("following toolpath %s of '%s': %.1f mm3 in voxels of %g mm", toolpath_id_.c_str(),
             read.toolpath.part_name.c_str(), followed_->plannedVolume(),
             settings_.simulation.deposition.voxel_mm);
    publishState();
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR("cannot follow toolpath %s: %s: %s", toolpath_id_.c_str(), toString(failure.code),
              failure.message.c_str());
  }
}

/// A host that is behind with poses must not leave out what grew meanwhile.
void DepositFollowing::follow(const Point3& tip) {
  followed_->observe(tip);
  const double grown_mm3 = followed_->deposit().totals().extruded_mm3 - published_mm3_;
  if (grown_mm3 >= kShare * followed_->plannedVolume()) publish();
}

void DepositFollowing::publish() {
  if (!followed_) return;
  const double extruded_mm3 = followed_->deposit().totals().extruded_mm3;
  if (extruded_mm3 != published_mm3_ || followed_->isComplete() != was_complete_) publishState();
  const VoxelGrid& grid = followed_->deposit().grid();
  if (extruded_mm3 != cloud_mm3_ && deposited_.getNumSubscribers() > 0) {
    publishLatched(deposited_, depositedCloud(grid, settings_.shown));
    cloud_mm3_ = extruded_mm3;
  }
  if (extruded_mm3 != markers_mm3_ && markers_.getNumSubscribers() > 0) {
    publishLatched(markers_, depositedMarkers(grid, settings_.shown));
    markers_mm3_ = extruded_mm3;
  }
}

void DepositFollowing::publishState() {
  const VoxelDeposit& deposit = followed_->deposit();
  const DepositTotals totals = deposit.totals();
  lamina_msgs::DepositionState state;
  state.header.stamp = ros::Time::now();
  state.header.frame_id = names::kBedFrame;
  state.toolpath_id = toolpath_id_;
  state.planned_volume = toCubicMetres(followed_->plannedVolume());
  state.fraction = static_cast<float>(totals.extruded_mm3 / followed_->plannedVolume());
  state.is_complete = followed_->isComplete();
  state.summary = toMessage(summaryOf(deposit.grid(), totals, deposit.highest()));
  publishLatched(state_, state);
  published_mm3_ = totals.extruded_mm3;
  was_complete_ = state.is_complete != 0;
}

}  // namespace lamina
