// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "emulated_machine_node.hpp"

#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <cmath>

#include "conversions.hpp"
#include "lamina/base/error.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "point_cloud.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kNoBound = 0;        // of a queue: a position that is lost is a place that is wrong
constexpr std::uint32_t kProfiles = 100000;  // that may wait for a slow subscriber, which sees what it lost

/// The same wherever linear axes take it.
Eigen::Vector3d toolAxisOf(const CartesianMachine& machine) {
  return bedFromNozzle(machine, axisValues(machine, Point3::Zero())).linear().col(2).normalized();
}

}  // namespace

EmulatedMachineNode::EmulatedMachineNode(ros::NodeHandle node, const EmulatedMachineSettings& settings)
    : settings_(settings),
      machine_(machineOf(settings.machine)),
      rest_(node.advertiseService(names::kMachineRest, &EmulatedMachineNode::onMachineRest, this)),
      position_(node.advertise<sensor_msgs::JointState>(names::kMachinePosition, kNoBound, true)),
      profile_(node.advertise<sensor_msgs::PointCloud2>(names::kProfile, kProfiles)),
      deposited_(node.advertise<sensor_msgs::PointCloud2>(names::kDeposited, 1, true)),
      bed_from_program_(programFromBed(machine_).inverse()),
      tool_axis_(toolAxisOf(machine_)),
      deposit_(bareBed(buildSpaceOf(machine_), tool_axis_, settings)),
      surface_from_bed_(deposit_->bedFromSurface().inverse()),
      shown_(deposit_->surface().grid.area()),
      sensor_(settings.sensor) {
  EmulatedObserver observer;
  observer.motion = [this](const ExecutedMotion& motion) { motions_.push(motion); };
  emulator_ = std::make_unique<EmulatedMachine>(settings_.emulator, faultsOf(settings_), portsOf(settings_),
                                                observer);
  start_ = ros::Time::now();  // after the machine's own: no stamp is older than what it is of
  ROS_INFO("machine %s at %s, %g times as fast as real", machine_.name.c_str(), emulator_->pty().c_str(),
           settings_.emulator.speed_up);
  if (emulator_->tcpPort() != 0) ROS_INFO("machine at tcp:127.0.0.1:%d", emulator_->tcpPort());
  publishPosition({0.0, bed_from_program_ * Point3::Zero()});
  worker_ = std::thread([this] { run(); });
}

EmulatedMachineNode::~EmulatedMachineNode() {
  motions_.close();
  emulator_.reset();
  worker_.join();
}

bool EmulatedMachineNode::onMachineRest(lamina_msgs::MachineRest::Request&,
                                        lamina_msgs::MachineRest::Response& response) {
  response.is_resting = motions_.isAtRest();
  const std::lock_guard<std::mutex> lock(stamps_mutex_);
  response.last_position = last_.position;
  response.last_profile = last_.profile;
  return true;
}

void EmulatedMachineNode::run() {
  const auto period = std::chrono::milliseconds(static_cast<int>(1e3 * settings_.deposited_period_s) + 1);
  auto publish_at = std::chrono::steady_clock::now() + period;
  while (!motions_.isClosed()) {
    if (const auto motion = motions_.pop(period)) tryExecute(*motion);
    if (!has_news_ || std::chrono::steady_clock::now() < publish_at) continue;
    publishDeposited();
    publish_at = std::chrono::steady_clock::now() + period;
  }
}

/// A motion that leads out of what can be shown must not end the machine.
void EmulatedMachineNode::tryExecute(const ExecutedMotion& motion) {
  constexpr double kQuiet = 5.0;  // s
  try {
    execute(motion);
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(kQuiet, "a motion is neither shown nor deposited: %s", error.what());
  }
}

void EmulatedMachineNode::execute(const ExecutedMotion& motion) {
  // After a rest the nozzle sets out later than it arrived.
  if (motion.start_s > last_end_s_) publishPosition({motion.start_s, bed_from_program_ * motion.start});
  last_end_s_ = motion.end_s;
  const double area = 0.25 * M_PI * settings_.filament_diameter_mm * settings_.filament_diameter_mm;
  const double volume = std::max(motion.filament_mm, 0.0) * area;
  const bool moves = (motion.end - motion.start).norm() > 0.0;
  const bool deposits = moves && volume > 0.0;
  const bool measures =
      moves && (!deposits || settings_.profile_while_depositing) && profile_.getNumSubscribers() > 0;
  std::vector<MotionSample> samples =
      samplesOf(motion, measures ? settings_.profile_spacing_mm : settings_.position_spacing_mm);
  for (MotionSample& sample : samples) sample.position = bed_from_program_ * sample.position;
  if (!deposits) endBead();
  Point3 from = bed_from_program_ * motion.start;
  double from_s = motion.start_s;
  for (const MotionSample& sample : samples) {
    // Piece by piece, so that the sensor never sees what is still to come.
    const double piece_mm3 = deposits ? volume / static_cast<double>(samples.size()) : 0.0;
    if (deposits) lay({from, sample.position, tool_axis_, tool_axis_, piece_mm3}, {from_s, sample.time_s});
    from = sample.position;
    from_s = sample.time_s;
    publishPosition(sample);
    if (measures) publishProfile(sample, &sample == &samples.back() ? Blank::Published : Blank::LeftOut);
  }
}

void EmulatedMachineNode::lay(const ToolAxisMotion& motion, const MachineTimes& times) {
  const Point3& to = motion.end;
  const Point2 at = (surface_from_bed_ * to).head<2>();
  const bool is_shown = (at - shown_.low).minCoeff() >= 0.0 && (shown_.high - at).minCoeff() > 0.0;
  if (!is_shown)
    ROS_WARN_ONCE("material deposited at %.1f, %.1f mm is not kept: it lies beyond the bed that is shown",
                  to.x(), to.y());
  deposit_->lay(motion, times);
  is_laying_ = true;
  has_news_ = true;
}

/// A bead that stands once it has ended was not shown while it was laid.
void EmulatedMachineNode::endBead() {
  deposit_->endBead();
  has_news_ = has_news_ || is_laying_;
  is_laying_ = false;
}

ros::Time EmulatedMachineNode::stampOf(double machine_s) const {
  const double speed_up = settings_.emulator.speed_up > 0.0 ? settings_.emulator.speed_up : 1.0;
  return start_ + ros::Duration(machine_s / speed_up);
}

void EmulatedMachineNode::publishPosition(const MotionSample& sample) {
  sensor_msgs::JointState message = jointState(machine_, axisValues(machine_, sample.position));
  message.header.stamp = stampOf(sample.time_s);
  publishLatched(position_, message);
  const std::lock_guard<std::mutex> lock(stamps_mutex_);
  last_.position = message.header.stamp;
}

void EmulatedMachineNode::publishProfile(const MotionSample& sample, Blank blank) {
  const Eigen::Isometry3d bed_from_nozzle = bedFromNozzle(machine_, axisValues(machine_, sample.position));
  const Eigen::Isometry3d surface_from_sensor(
      (surface_from_bed_ * bed_from_nozzle * machine_.nozzle_from_sensor).matrix());
  const auto points =
      sensor_.measure(deposit_->surface(), surface_from_sensor, deposit_->highest(), sample.time_s);
  if (points.empty() && blank == Blank::LeftOut) return;
  sensor_msgs::PointCloud2 message = toCloudMessage(points);
  message.header.stamp = stampOf(sample.time_s + sensor_.stampError());
  message.header.frame_id = names::kSensorFrame;
  profile_.publish(message);
  const std::lock_guard<std::mutex> lock(stamps_mutex_);
  last_.profile = message.header.stamp;
}

void EmulatedMachineNode::publishDeposited() {
  if (deposited_.getNumSubscribers() == 0) return;
  has_news_ = false;
  sensor_msgs::PointCloud2 message = toCloudMessage(deposit_->points());
  message.header.stamp = last_.position;  // written by this thread alone
  message.header.frame_id = names::kBedFrame;
  publishLatched(deposited_, message);
}

}  // namespace lamina
