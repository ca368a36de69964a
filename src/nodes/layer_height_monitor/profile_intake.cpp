// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "profile_intake.hpp"

#include <boost/make_shared.hpp>

#include <algorithm>
#include <limits>
#include <utility>

#include "lamina/base/error.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina {
namespace {

constexpr double kTurn = 0.02;               // s between looks at what is due
constexpr std::uint32_t kNoIntakeBound = 0;  // of a queue
constexpr double kBytesPerMb = 1e6;

/// Of memory: a cloud without points takes some as well.
std::uint64_t bytesOf(const sensor_msgs::PointCloud2& cloud) {
  return sizeof(cloud) + cloud.fields.size() * sizeof(sensor_msgs::PointField) + cloud.data.size();
}

}  // namespace

ProfileIntake::ProfileIntake(ros::NodeHandle node, double queue_mb, CalibratedSensor sensor,
                             Receivers receivers)
    : transforms_(sequence_, node),
      queue_bytes_(queue_mb * kBytesPerMb),
      sensor_(std::move(sensor)),
      receivers_(std::move(receivers)) {
  timer_ = node.createWallTimer(ros::WallDuration(kTurn), [this](const ros::WallTimerEvent&) { passDue(); });
  const boost::function<void(const CloudEvent&)> onMessage = [this](const CloudEvent& event) {
    onCloud(event);
  };
  // What has to be left out is left out, and counted, by `wait`.
  subscriber_ = node.subscribe<sensor_msgs::PointCloud2>(names::kProfile, kNoIntakeBound, onMessage, {},
                                                         ros::TransportHints().tcpNoDelay());
}

void ProfileIntake::onCloud(const CloudEvent& event) {
  const Cloud cloud = event.getMessage();
  counts_.received.add(*cloud);
  stamps_.add(cloud->header.stamp);
  countLost(event);
  const Cloud known = cloud->header.frame_id.empty() ? nullptr : taken(cloud);
  if (known == nullptr)
    counts_.without_frame.add(*cloud);
  else
    wait(known);
}

/// The cloud at the time at which it was taken; null without such a time. To tf a stamp of zero is the latest
/// time there is, at which no cloud was taken.
ProfileIntake::Cloud ProfileIntake::taken(const Cloud& cloud) {
  if (cloud->header.stamp.isZero()) return nullptr;
  const double offset_s = offsetOf(cloud->header.frame_id);
  if (offset_s == 0.0) return cloud;
  const double time_s = cloud->header.stamp.toSec() - offset_s;
  if (!(time_s > 0.0) || time_s > std::numeric_limits<std::int32_t>::max()) return nullptr;
  const auto known = boost::make_shared<sensor_msgs::PointCloud2>(*cloud);
  known->header.stamp -= ros::Duration(offset_s);
  return known;
}

/// By how much the stamps of a sensor are late. One that is stated is not the calibrated one.
double ProfileIntake::offsetOf(const std::string& frame) {
  const auto other = sensor_.other_time_offsets_s.find(bareFrame(frame));
  if (other != sensor_.other_time_offsets_s.end()) return other->second;
  return calibrated_frame_.see(frame) ? sensor_.time_offset_s : 0.0;
}

/// The frame that tf has to place for a cloud's.
std::string ProfileIntake::placedBy(const std::string& frame) const {
  return sensor_.nozzle_from_sensor && calibrated_frame_.is(frame) ? names::kNozzleFrame : frame;
}

void ProfileIntake::countLost(const CloudEvent& event) {
  const std::uint32_t sequence = event.getMessage()->header.seq;
  const auto [last, is_first] = last_sequence_.insert({event.getPublisherName(), sequence});
  if (!is_first && sequence > last->second) counts_.lost += sequence - last->second - 1;
  last->second = sequence;
}

void ProfileIntake::wait(const Cloud& cloud) {
  counts_.waiting.add(*cloud);
  counts_.waiting_bytes += bytesOf(*cloud);
  waiting_[cloud->header.frame_id].insert({cloud->header.stamp, cloud});
  if (isTooFull()) passDue();  // what can be placed is not pushed out
  if (!isTooFull()) return;
  constexpr double kQuiet = 10.0;  // s
  ROS_WARN_STREAM_THROTTLE(kQuiet, counts_.waiting.clouds
                                       << " clouds that wait for tf take " << counts_.waiting_bytes
                                       << " bytes; expected at most queue_mb = " << queue_bytes_ / kBytesPerMb
                                       << " MB: the oldest are pushed out");
  while (isTooFull()) pushOutOldest();
}

bool ProfileIntake::isTooFull() const { return static_cast<double>(counts_.waiting_bytes) > queue_bytes_; }

bool ProfileIntake::hasCome(const ros::Time& position, const ros::Time& profile) {
  if (!stamps_.haveReached(profile)) return false;
  passDue();
  // Only then: what tf passes is forgotten in time, and clouds may still need it.
  const bool has_position =
      position.isZero() || sequence_.passTo(names::kNozzleFrame, position) != Readiness::NotYet;
  addNozzles();
  return has_position && !isHeldUp(position);
}

/// Whether a cloud waits that tf can still place: its frame hangs on the bed.
bool ProfileIntake::isHeldUp(const ros::Time& until) const {
  return std::any_of(waiting_.begin(), waiting_.end(), [&](const auto& of_frame) {
    const auto& [frame, clouds] = of_frame;
    return !clouds.empty() && clouds.begin()->first <= until &&
           lookUp(sequence_.buffer(), names::kBedFrame, placedBy(frame), ros::Time(0));
  });
}

IntakeCounts ProfileIntake::counts() const {
  IntakeCounts counts = counts_;
  counts.transforms_forced = sequence_.forced();
  return counts;
}

void ProfileIntake::leaveOutWaiting(CloudTally& as) {
  for (auto& [frame, clouds] : waiting_) {
    for (const auto& [stamp, cloud] : clouds) settle(*cloud, as);
    clouds.clear();
  }
}

/// Clouds of before ROS time went back have lost their transforms.
void ProfileIntake::followTime() {
  const std::uint64_t restarts = sequence_.restarts();
  if (std::exchange(restarts_, restarts) == restarts) return;
  leaveOutWaiting(counts_.pushed_out);
  stamps_ = {};
  receivers_.restarted();
}

void ProfileIntake::startOver() {
  leaveOutWaiting(counts_.of_former_print);
  while (sequence_.passNext()) {
  }
  sequence_.takeNozzles();
}

void ProfileIntake::pushOutOldest() {
  Clouds* oldest = nullptr;
  for (auto& [frame, clouds] : waiting_)
    if (!clouds.empty() && (oldest == nullptr || clouds.begin()->first < oldest->begin()->first))
      oldest = &clouds;
  if (oldest == nullptr) return;
  settle(*oldest->begin()->second, counts_.pushed_out);
  oldest->erase(oldest->begin());
}

/// A cloud that waited no longer does.
void ProfileIntake::settle(const sensor_msgs::PointCloud2& cloud, CloudTally& as) {
  --counts_.waiting.clouds;
  counts_.waiting.points -= std::uint64_t{cloud.width} * cloud.height;
  counts_.waiting_bytes -= bytesOf(cloud);
  as.add(cloud);
}

void ProfileIntake::passDue() {
  followTime();
  addNozzles();  // of transforms that went on unasked
  std::set<std::string> passed_over;
  for (;;) {
    const std::string frame = nextFrame(passed_over);
    if (frame.empty()) return;
    if (passFirst(frame)) continue;
    // Clouds of a frame that hangs on nothing hold up no others.
    if (lookUp(sequence_.buffer(), names::kBedFrame, placedBy(frame), ros::Time(0))) return;
    passed_over.insert(frame);
  }
}

std::string ProfileIntake::nextFrame(const std::set<std::string>& passed_over) const {
  const Clouds::value_type* oldest = nullptr;
  for (const auto& [frame, clouds] : waiting_) {
    if (clouds.empty() || passed_over.count(frame) > 0 || !sequence_.knows(placedBy(frame))) continue;
    if (oldest == nullptr || clouds.begin()->first < oldest->first) oldest = &*clouds.begin();
  }
  return oldest == nullptr ? "" : oldest->second->header.frame_id;
}

/// Whether the oldest cloud of a frame could be worked off.
bool ProfileIntake::passFirst(const std::string& frame) {
  Clouds& clouds = waiting_.at(frame);
  const Cloud cloud = clouds.begin()->second;
  const Readiness ready = sequence_.passTo(placedBy(frame), cloud->header.stamp);
  if (ready == Readiness::NotYet) return false;
  const Readiness nozzle = sequence_.passTo(names::kNozzleFrame, cloud->header.stamp);
  if (ready == Readiness::Ready && nozzle == Readiness::NotYet) return false;
  addNozzles();
  clouds.erase(clouds.begin());
  if (ready == Readiness::Never)
    settle(*cloud, counts_.without_transform);
  else if (nozzle == Readiness::Never)
    settle(*cloud, counts_.without_nozzle);
  else
    place(*cloud);
  return true;
}

void ProfileIntake::addNozzles() {
  for (const StampedNozzle& nozzle : sequence_.takeNozzles()) receivers_.nozzle(nozzle);
}

void ProfileIntake::place(const sensor_msgs::PointCloud2& cloud) {
  const std::string& frame = cloud.header.frame_id;
  auto bed_from_cloud = lookUp(sequence_.buffer(), names::kBedFrame, placedBy(frame), cloud.header.stamp);
  if (!bed_from_cloud) return settle(cloud, counts_.without_transform);
  if (sensor_.nozzle_from_sensor && calibrated_frame_.is(frame))
    *bed_from_cloud = *bed_from_cloud * *sensor_.nozzle_from_sensor;
  PlacedProfile profile;
  profile.stamp = cloud.header.stamp;
  try {
    CloudPoints read = fromMessage(cloud, *bed_from_cloud);
    counts_.points_not_finite += read.not_finite;
    profile.points = std::move(read.points);
  } catch (const InvalidInput& error) {
    counts_.last_fault = error.what();
    return settle(cloud, counts_.malformed);
  }
  settle(cloud, counts_.placed);
  receivers_.profile(profile);
}

}  // namespace lamina
