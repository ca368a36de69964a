// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/stamped_heights.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace lamina {
namespace {

constexpr double kNanoseconds = 1e9;                // in a second
constexpr std::int64_t kLongestRest = 100'000'000;  // ns between two profiles of a nozzle at rest that count

}  // namespace

StampedHeights::StampedHeights(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                               const MonitorSettings& settings)
    : pose_gap_mm_(settings.pose_gap_mm),
      quiet_ns_(kNanoseconds * settings.quiet_s),
      monitor_(std::move(toolpath), bed_from_part, settings) {}

LayerHeightReports StampedHeights::observe(const StampedTip& pose) {
  const bool is_passed = reached_ && pose.stamp_ns < reached_->stamp_ns;
  if (is_passed) return {};
  poses_.insert({pose.stamp_ns, pose.tip});
  workOff();
  while (poses_.size() > kMostPoses) passBy();
  return std::exchange(done_, {});
}

LayerHeightReports StampedHeights::insert(StampedProfile profile) {
  use_.received.add(profile.points.size());
  if (worked_off_ns_ && profile.stamp_ns < *worked_off_ns_) {
    use_.late.add(profile.points.size());
    return {};
  }
  waiting_.insert({profile.stamp_ns, std::move(profile.points)});
  workOff();
  return std::exchange(done_, {});
}

void StampedHeights::report(LayerHeightReports more) {
  std::move(more.begin(), more.end(), std::back_inserter(done_));
}

void StampedHeights::workOff() {
  while (!waiting_.empty()) {
    const std::int64_t stamp_ns = waiting_.begin()->first;
    while (!(reached_ && reached_->stamp_ns >= stamp_ns)) {
      if (poses_.empty() || poses_.rbegin()->first < stamp_ns) return;
      step();
    }
    const StampedProfile profile{stamp_ns, std::move(waiting_.begin()->second)};
    waiting_.erase(waiting_.begin());
    worked_off_ns_ = stamp_ns;
    place(profile);
  }
}

/// On to the next pose.
void StampedHeights::step() {
  const StampedTip next{poses_.begin()->first, poses_.begin()->second};
  poses_.erase(poses_.begin());
  way_mm_ = reached_ ? (next.tip - reached_->tip).norm() : 0.0;
  if (reached_ && was_moving_) moved_ns_ += reached_->stamp_ns - way_begin_ns_;
  way_begin_ns_ = reached_ ? reached_->stamp_ns : next.stamp_ns;
  was_moving_ = way_mm_ > 0.0;
  reached_ = next;
  report(monitor_.move(monitor_.heightOf(next.tip)));
  if (!monitor_.isScanning()) cells_in_scan_ = 0;
}

/// On to the next pose without the profiles of the motion before, which may yet come.
void StampedHeights::passBy() {
  step();
  worked_off_ns_ = std::max(worked_off_ns_.value_or(way_begin_ns_), way_begin_ns_);
}

void StampedHeights::place(const StampedProfile& profile) {
  const bool is_between = profile.stamp_ns < reached_->stamp_ns;
  if (is_between && way_mm_ > pose_gap_mm_) return use_.in_gap.add(profile.points.size());
  report(monitor_.add(profile.points));
  (monitor_.isScanning() ? use_.of_layers : use_.of_no_layer).add(profile.points.size());
  if (!monitor_.isScanning()) return;
  quiet_for_ns_ += passedUntil(profile.stamp_ns);
  // Until a scan has shown something it cannot fall quiet.
  if (monitor_.cellsInScan() != cells_in_scan_ || monitor_.cellsInScan() == 0) quiet_for_ns_ = 0;
  cells_in_scan_ = monitor_.cellsInScan();
  if (static_cast<double>(quiet_for_ns_) > quiet_ns_) report(monitor_.closeScan(LayerSight::Seen));
}

/// Since the profile before. A machine that rests without profiles waits for its host, which says nothing of
/// the scan.
std::int64_t StampedHeights::passedUntil(std::int64_t stamp_ns) {
  const std::int64_t moved_ns = moved_ns_ + (was_moving_ ? stamp_ns - way_begin_ns_ : 0);
  const std::int64_t moving_ns = moved_ns - moved_at_profile_ns_;
  const std::int64_t resting_ns = stamp_ns - last_profile_ns_ - moving_ns;
  moved_at_profile_ns_ = moved_ns;
  last_profile_ns_ = stamp_ns;
  return moving_ns + std::min(resting_ns, kLongestRest);
}

LayerHeightReports StampedHeights::restartClock() {
  while (!poses_.empty()) step();
  for (const auto& [stamp_ns, points] : waiting_) use_.late.add(points.size());
  waiting_.clear();
  reached_.reset();
  worked_off_ns_.reset();
  was_moving_ = false;
  way_begin_ns_ = moved_ns_ = moved_at_profile_ns_ = last_profile_ns_ = 0;
  return std::exchange(done_, {});
}

LayerHeightReports StampedHeights::cutShort() { return monitor_.closeScan(LayerSight::CutShort); }

LayerHeightReports StampedHeights::finish() {
  while (!poses_.empty()) step();
  report(monitor_.finish());
  return std::exchange(done_, {});
}

ProfileUse StampedHeights::use() const {
  ProfileUse use = use_;
  for (const auto& [stamp_ns, points] : waiting_) use.waiting.add(points.size());
  use.points_outside = monitor_.pointsOutside();
  return use;
}

}  // namespace lamina
