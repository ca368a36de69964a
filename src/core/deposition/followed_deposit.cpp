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

Eigen::Vector3d jetBetween(const JetMotion& motion, double fraction) {
  if (motion.start_jet == motion.end_jet) return motion.start_jet;
  const Eigen::Vector3d jet = between(motion.start_jet, motion.end_jet, fraction);
  return jet.norm() > 1e-6 ? Eigen::Vector3d(jet.normalized()) : motion.start_jet;
}

/// A motion from one fraction of it to another.
JetMotion partOf(const JetMotion& whole, double from, double until) {
  JetMotion part = whole;
  part.start = between(whole.start, whole.end, from);
  part.end = between(whole.start, whole.end, until);
  part.start_jet = jetBetween(whole, from);
  part.end_jet = jetBetween(whole, until);
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
    if (isLaid(*path, settings_))
      for (const JetMotion& motion : jetMotions(*path)) planned_mm3_ += motion.volume_mm3;
}

void FollowedDeposit::observe(const Point3& tip) { layUpTo(follower_.observe(tip)); }

void FollowedDeposit::layUpTo(const PathPlace& place) {
  const std::vector<const Path*>& paths = follower_.paths();
  while (std::tie(laid_.path, laid_.motion) < std::tie(place.path, place.motion)) {
    const Path& path = *paths[laid_.path];
    layPart(path, 1.0);
    laid_ = laid_.motion + 1 < path.motionCount() ? PathPlace{laid_.path, laid_.motion + 1, 0.0}
                                                  : PathPlace{laid_.path + 1, 0, 0.0};
  }
  if (follower_.isAtEnd()) return;
  const Path& path = *paths[laid_.path];
  const double length = (path.points[path.motionEnd(laid_.motion)] - path.points[laid_.motion]).norm();
  if ((place.fraction - laid_.fraction) * length < kLeastPiece) return;
  layPart(path, place.fraction);
  laid_.fraction = place.fraction;
}

/// Lays the motion that is being laid up to a fraction of it.
void FollowedDeposit::layPart(const Path& path, double until) {
  if (!isLaid(path, settings_)) return;
  if (path.deposit == Deposit::Bead) {
    deposit_.lay(partOf(jetMotion(path, laid_.motion), laid_.fraction, until));
    return;
  }
  if (laid_.motion == 0 && laid_.fraction == 0.0) deposit_.lay(jetDrop(path, 0));
  const bool leads_on = laid_.motion < path.motionCount() && path.motionEnd(laid_.motion) != 0;
  if (until == 1.0 && leads_on) deposit_.lay(jetDrop(path, path.motionEnd(laid_.motion)));
}

}  // namespace lamina
