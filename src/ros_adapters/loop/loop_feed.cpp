// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop/loop_feed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "conversions.hpp"
#include "correction_messages.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "tf/frames.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina {
namespace {

double bytesOfCloud(const sensor_msgs::PointCloud2& cloud) {
  return static_cast<double>(sizeof(cloud) + cloud.fields.size() * sizeof(sensor_msgs::PointField) +
                             cloud.data.size());
}

std::int64_t nanoseconds(const ros::Time& time) { return static_cast<std::int64_t>(time.toNSec()); }

/// When a cloud of that stamp was taken; none where that is no time of tf, to which zero is the latest.
std::optional<ros::Time> takenAt(const ros::Time& stamp, double offset_s) {
  const std::int64_t taken = nanoseconds(stamp) - std::llround(1e9 * offset_s);
  constexpr std::int64_t kGreatest = std::int64_t{std::numeric_limits<std::int32_t>::max()} * 1'000'000'000;
  if (stamp.isZero() || taken <= 0 || taken > kGreatest) return std::nullopt;
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(taken));
  return time;
}

}  // namespace

FeedCounts since(const FeedCounts& then, const FeedCounts& now) {
  FeedCounts counts = now;
  counts.received -= then.received - then.waiting;
  counts.placed -= then.placed;
  counts.without_frame -= then.without_frame;
  counts.without_offset -= then.without_offset;
  counts.malformed -= then.malformed;
  counts.without_transform -= then.without_transform;
  counts.pushed_out -= then.pushed_out;
  counts.of_former_print -= then.of_former_print;
  return counts;
}

LoopFeed::LoopFeed(const LoopRunSettings& settings, double queue_mb)
    : settings_(settings),
      queue_bytes_(1e6 * queue_mb),
      other_offsets_s_(otherTimeOffsets(settings.calibration.other_time_offsets_s)) {
  timeOffsetSigmas(settings.calibration);  // refused here, and not by the first toolpath
}

bool LoopFeed::add(const lamina_msgs::Toolpath& toolpath) {
  if (run_) {
    counts_.of_former_print += leaveOutWaiting();
    while (sequence_.passNext()) {
    }
    sequence_.takeNozzles();
  }
  if (run_ && run_->follow(toolpath.id)) return true;
  run_.reset();
  heard_.clear();
  MachineToolpath placed = fromMessage(toolpath);
  run_ = std::make_unique<LoopRun>(PlacedPart{std::move(placed.id), placed.bed_from_part,
                                              std::move(placed.toolpath), std::move(placed.machine)},
                                   settings_);
  return false;
}

void LoopFeed::add(const geometry_msgs::TransformStamped& transform, const std::string& authority) {
  sequence_.add(transform, authority);
}

void LoopFeed::addFixed(const geometry_msgs::TransformStamped& transform, const std::string& authority) {
  sequence_.addFixed(transform, authority);
}

/// By how much the stamps of a sensor are late; none if nobody said so.
std::optional<double> LoopFeed::offsetOf(const std::string& frame) {
  const auto other = other_offsets_s_.find(bareFrame(frame));
  if (other != other_offsets_s_.end()) return other->second;
  if (calibrated_frame_.see(frame)) return settings_.calibration.time_offset_s;
  return std::nullopt;
}

void LoopFeed::add(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  ++counts_.received;
  const std::string& frame = cloud->header.frame_id;
  if (frame.empty() || cloud->header.stamp.isZero()) {
    ++counts_.without_frame;
    return;
  }
  const auto offset_s = offsetOf(frame);
  if (!offset_s) {
    ++counts_.without_offset;
    counts_.last_without_offset = frame;
    return;
  }
  const auto taken = takenAt(cloud->header.stamp, *offset_s);
  if (!taken) {
    ++counts_.without_frame;
    return;
  }
  ++counts_.waiting;
  ++waiting_of_[frame];
  waiting_bytes_ += bytesOfCloud(*cloud);
  waiting_.insert({*taken, cloud});
  while (waiting_bytes_ > queue_bytes_ && !waiting_.empty()) pushOutOldest();
}

void LoopFeed::pushOutOldest() {
  settle(*waiting_.begin()->second);
  ++counts_.pushed_out;
  waiting_.erase(waiting_.begin());
}

/// A cloud that waited no longer does.
void LoopFeed::settle(const sensor_msgs::PointCloud2& cloud) {
  --counts_.waiting;
  waiting_bytes_ -= bytesOfCloud(cloud);
  const auto of_frame = waiting_of_.find(cloud.header.frame_id);
  if (--of_frame->second == 0) waiting_of_.erase(of_frame);
}

/// @return the number of clouds
std::size_t LoopFeed::leaveOutWaiting() {
  const std::size_t clouds = waiting_.size();
  counts_.waiting -= clouds;
  waiting_.clear();
  waiting_of_.clear();
  waiting_bytes_ = 0.0;
  return clouds;
}

/// Clouds of before ROS time went back have lost their transforms.
void LoopFeed::followTime() {
  const std::uint64_t restarts = sequence_.restarts();
  if (std::exchange(restarts_, restarts) == restarts) return;
  counts_.pushed_out += leaveOutWaiting();
  heard_.clear();
  if (run_) run_->restartClock();
}

void LoopFeed::hear(const std_msgs::Header& header) {
  if (header.frame_id.empty()) return;
  const auto offset_s = offsetOf(header.frame_id);
  const auto taken = offset_s ? takenAt(header.stamp, *offset_s) : std::nullopt;
  if (!taken) return;
  HeardSensor& sensor = heard_[header.frame_id];
  // A single stamp far ahead, of a clock that is set or garbled, says nothing of tf.
  if (sensor.last) sensor.waiting = std::min(*sensor.last, *taken);
  sensor.last = taken;
}

bool LoopFeed::add(const lamina_msgs::AppliedCorrection& applied) {
  if (!run_) return false;
  const std::string& toolpath_id = run_->part().toolpath_id;
  if (isPlanOf(applied.toolpath_id, toolpath_id) && isRefusalOfPlan(applied))
    return run_->refusePlan(applied.toolpath_id, applied.reason);
  if (applied.toolpath_id != toolpath_id) return false;
  const CorrectionMap* const coasting = run_->coastingMap(applied.layer);
  if (coasting != nullptr && !applied.digest.empty() && applied.digest == toMessage(*coasting).digest)
    run_->missMap({applied.layer, applied.waited, applied.reason, {}, true});
  else if (const auto missed = missedOf(applied))
    run_->missMap(*missed);
  else
    run_->refuseTrim(applied.layer, applied.reason);
  return true;
}

void LoopFeed::pass() {
  followTime();
  if (!run_) return;  // the first toolpath may come after its clouds
  do {
    placeClouds();
    for (const StampedNozzle& nozzle : sequence_.takeNozzles())
      run_->observe({nanoseconds(nozzle.stamp), nozzle.bed_from_nozzle.translation()});
  } while (sequence_.passNext());
  for (auto& [frame, sensor] : heard_) {
    if (!sensor.waiting) continue;
    run_->hear(nanoseconds(*sensor.waiting), frame);
    sensor.waiting.reset();
  }
}

void LoopFeed::passAll() {
  pass();
  if (run_) run_->passAll();
}

void LoopFeed::finish() {
  pass();
  if (run_) run_->finish();
}

void LoopFeed::request(LoopRequest request) {
  settings_.request = request;
  if (!run_) return;
  const LoopStatus& status = run_->request(request);
  if (status.state == LoopState::Blocked) throw Rejected("the loop is blocked: " + status.reason);
}

void LoopFeed::recalibrate(const LoopRunSettings& settings) {
  other_offsets_s_ = otherTimeOffsets(settings.calibration.other_time_offsets_s);
  settings_.calibration = settings.calibration;
  settings_.sight = settings.sight;
  settings_.loop = settings.loop;
  if (run_) run_->recalibrate(settings_.calibration, settings_.request);
}

void LoopFeed::placeClouds() {
  std::set<std::string> ahead;  // frames that tf has not come up to
  // Of thousands of clouds that wait only the first of each frame is looked at.
  for (auto cloud = waiting_.begin(); cloud != waiting_.end() && ahead.size() < waiting_of_.size();) {
    const std::string frame = placedBy(*cloud->second);
    if (ahead.count(frame) > 0 || !place(cloud->first, *cloud->second)) {
      ahead.insert(frame);
      ++cloud;
      continue;
    }
    cloud = waiting_.erase(cloud);
  }
}

/// Whether it is of the sensor whose place at the nozzle was calibrated: others are where tf has them.
bool LoopFeed::isCalibrated(const sensor_msgs::PointCloud2& cloud) const {
  return settings_.calibration.nozzle_from_sensor && calibrated_frame_.is(cloud.header.frame_id);
}

/// The frame that tf has to place.
std::string LoopFeed::placedBy(const sensor_msgs::PointCloud2& cloud) const {
  return isCalibrated(cloud) ? names::kNozzleFrame : cloud.header.frame_id;
}

/// Whether the cloud no longer waits.
bool LoopFeed::place(const ros::Time& taken, const sensor_msgs::PointCloud2& cloud) {
  const std::string frame = placedBy(cloud);
  const Readiness ready = readiness(sequence_.buffer(), names::kBedFrame, frame, taken);
  if (ready == Readiness::NotYet) return false;
  settle(cloud);
  auto bed_from_sensor = lookUp(sequence_.buffer(), names::kBedFrame, frame, taken);
  if (ready == Readiness::Never || !bed_from_sensor) {
    ++counts_.without_transform;
    return true;
  }
  if (isCalibrated(cloud)) *bed_from_sensor = *bed_from_sensor * *settings_.calibration.nozzle_from_sensor;
  try {
    run_->see({nanoseconds(taken), *bed_from_sensor, profilesFromMessage(cloud), cloud.header.frame_id});
    ++counts_.placed;
  } catch (const InvalidInput& error) {
    counts_.last_fault = error.what();
    ++counts_.malformed;
  }
  return true;
}

}  // namespace lamina
