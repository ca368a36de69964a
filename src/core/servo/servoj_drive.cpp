// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_drive.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kCallAgain = 3.0;  // s between calls of a robot that does not answer

std::vector<DrivenJoint> requireSixRotary(std::vector<DrivenJoint> joints) {
  const auto rotary = std::count_if(joints.begin(), joints.end(),
                                    [](const DrivenJoint& joint) { return joint.kind == JointKind::Rotary; });
  if (joints.size() != kServojJoints || rotary != kServojJoints)
    throw InvalidConfig("a robot of " + std::to_string(joints.size()) + " joints, " + std::to_string(rotary) +
                        " of them rotary; expected six rotary ones");
  return joints;
}

}  // namespace

void describe(SettingsSchema& schema, ServojDriveSettings& settings) {
  describe(schema, settings.servoj);
  describe(schema, settings.cyclic);
  describe(schema, settings.robot);
}

ServojDrive::ServojDrive(std::vector<DrivenJoint> joints, const ServojDriveSettings& settings)
    : caller_(settings.servoj, settings.robot),
      called_s_(clock_.now() - kCallAgain),
      link_(settings.servoj, settings.robot.report_silence_s),
      player_(requireSixRotary(joints), settings.cyclic, link_),
      joints_(std::move(joints)),
      actual_(JointValues::Zero(kServojJoints)) {
  SettingsSchema schema;
  ServojDriveSettings checked = settings;
  describe(schema, checked);
  schema.validate();
  thread_ = std::make_unique<PeriodicThread>(1.0 / link_.cycle(), [this](double due_s) { cycle(due_s); });
}

ServojDrive::~ServojDrive() {
  brake();
  while (!state().is_at_rest) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  thread_.reset();
  link_.stop();
}

void ServojDrive::cycle(double due_s) {
  const std::lock_guard<InheritingMutex> lock(mutex_);
  if (!link_.isOpen()) return;
  const double now_s = clock_.now();
  link_.read(now_s);
  if (link_.report()) {
    actual_ = link_.report()->position;
    if (!std::exchange(has_begun_, true)) player_.begin(actual_);
  }
  if (!has_begun_) return;
  if (const CyclicTarget* const target = player_.advance(due_s, now_s)) link_.send(*target);
  if (link_.isOpen()) return;
  // Nobody follows any more: what was planned is over.
  was_moving_ = !player_.isAtRest();
  has_begun_ = false;
  player_.begin(actual_);
}

std::string ServojDrive::keepConnected() {
  {
    const std::lock_guard<InheritingMutex> lock(mutex_);
    if (link_.isOpen()) return has_begun_ ? "" : "the robot reports nothing yet";
  }
  const double now_s = clock_.now();
  TcpSocket caller = caller_.called();
  if (caller.isOpen()) {
    const std::lock_guard<InheritingMutex> lock(mutex_);
    has_begun_ = false;
    link_.begin(std::move(caller), now_s);
    return "the robot reports nothing yet";
  }
  if (now_s - called_s_ < kCallAgain) return "the robot has not called back yet";
  called_s_ = now_s;
  try {
    caller_.sendProgram();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "the robot has not called back yet";
}

void ServojDrive::accept(const TrajectoryChunk& chunk) {
  const std::lock_guard<InheritingMutex> lock(mutex_);
  if (!isReady())
    throw Disconnected(std::string("no robot is connected") +
                       (link_.fault() != nullptr ? std::string(": ") + link_.fault() : ""));
  player_.accept(chunk, clock_.now());
  was_moving_ = false;
}

void ServojDrive::brake() {
  const std::lock_guard<InheritingMutex> lock(mutex_);
  player_.brake();
}

ServojDriveState ServojDrive::state() const {
  const std::lock_guard<InheritingMutex> lock(mutex_);
  ServojDriveState state;
  state.is_connected = isReady();
  state.is_at_rest = player_.isAtRest();
  state.actual = actual_;
  state.wanted = player_.target().now;
  if (was_moving_ && link_.fault() != nullptr) state.fault = link_.fault();
  if (player_.fault()) state.fault = faultText(*player_.fault(), joints_);
  return state;
}

}  // namespace lamina
