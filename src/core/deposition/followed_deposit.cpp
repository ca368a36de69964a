// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/followed_deposit.hpp"

#include <tuple>
#include <utility>

namespace lamina {
namespace {

Eigen::Vector3d between(const Eigen::Vector3d& start, const Eigen::Vector3d& end, double fraction) {
  return start + fraction * (end - start);
}

Eigen::Vector3d toolAxisBetween(const ToolAxisMotion& motion, double fraction) {
  if (motion.start_tool_axis == motion.end_tool_axis) return motion.start_tool_axis;
  const Eigen::Vector3d tool_axis = between(motion.start_tool_axis, motion.end_tool_axis, fraction);
  return tool_axis.norm() > 1e-6 ? Eigen::Vector3d(tool_axis.normalized()) : motion.start_tool_axis;
}

/// A motion from one fraction of it to another.
ToolAxisMotion partOf(const ToolAxisMotion& whole, double from, double until) {
  ToolAxisMotion part = whole;
  part.start = between(whole.start, whole.end, from);
  part.end = between(whole.start, whole.end, until);
  part.start_tool_axis = toolAxisBetween(whole, from);
  part.end_tool_axis = toolAxisBetween(whole, until);
  part.volume_mm3 = (until - from) * whole.volume_mm3;
  return part;
}

}  // namespace

FollowedDeposit::FollowedDeposit(Toolpath toolpath, const DepositionSettings& settings,
                                 const FollowingSettings& following)
    : toolpath_(std::move(toolpath)),
      settings_(settings),
      follower_(toolpath_, following),
      deposit_(roomFor(toolpath_, settings)) {
  for (const Path* path : follower_.paths())
    if (isDeposited(*path, settings_))
      for (const ToolAxisMotion& motion : toolAxisMotions(*path)) planned_mm3_ += motion.volume_mm3;
}

void FollowedDeposit::observe(const Point3& tip) { layUpTo(follower_.observe(tip)); }

void FollowedDeposit::layUpTo(const PathPosition& place) {
  const std::vector<const Path*>& paths = follower_.paths();
  while (std::tie(deposited_.path, deposited_.motion) < std::tie(place.path, place.motion)) {
    const Path& path = *paths[deposited_.path];
    layPart(path, 1.0);
    deposited_ = deposited_.motion + 1 < path.motionCount()
                     ? PathPosition{deposited_.path, deposited_.motion + 1, 0.0}
                     : PathPosition{deposited_.path + 1, 0, 0.0};
  }
  if (follower_.isAtEnd()) return;
  const Path& path = *paths[deposited_.path];
  const double length =
      (path.points[path.motionEnd(deposited_.motion)] - path.points[deposited_.motion]).norm();
  if ((place.fraction - deposited_.fraction) * length < kLeastPiece) return;
  layPart(path, place.fraction);
  deposited_.fraction = place.fraction;
}

/// Lays the motion that is being deposited up to a fraction of it.
void FollowedDeposit::layPart(const Path& path, double until) {
  if (!isDeposited(path, settings_)) return;
  if (path.deposit == Deposit::Bead) {
    deposit_.lay(partOf(toolAxisMotion(path, deposited_.motion), deposited_.fraction, until));
    return;
  }
  if (deposited_.motion == 0 && deposited_.fraction == 0.0) deposit_.lay(toolAxisDrop(path, 0));
  const bool leads_on = deposited_.motion < path.motionCount() && path.motionEnd(deposited_.motion) != 0;
  if (until == 1.0 && leads_on) deposit_.lay(toolAxisDrop(path, path.motionEnd(deposited_.motion)));
}

}  // namespace lamina
