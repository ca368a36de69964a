// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/base/threads/inheriting_mutex.hpp"
#include "lamina/base/threads/periodic_thread.hpp"
#include "lamina/servo/cyclic_player.hpp"
#include "lamina/servo/servoj_link.hpp"

namespace lamina {

/// Settings of a `ServojDrive`.
struct ServojDriveSettings {
  ServojSettings servoj;
  CyclicSettings cyclic;
  RobotAddress robot;
};

/// Adds the keys servoj.*, cyclic.* and robot.*.
void describe(SettingsSchema& schema, ServojDriveSettings& settings);

/// State of a `ServojDrive` at one instant.
struct ServojDriveState {
  bool is_connected = false;  ///< whether the robot is connected and has reported its position
  bool is_at_rest = true;     ///< whether no points are left to play
  JointValues actual;  ///< last position that the robot has reported [rad]; may be of an earlier connection
  JointTarget wanted;  ///< last target
  std::string fault;   ///< why the last motion has ended early, in words; empty if it has not
};

/// Drives a robot of Universal Robots: sends it the program, and plays chunks of a trajectory to it, cycle by
/// cycle, in a thread of its own. If the connection is lost, the motion is given up; `keepConnected` connects
/// again.
class ServojDrive {
 public:
  /// @throws InvalidConfig if the joints are not six rotary ones, or a setting is out of its bounds
  /// @throws DeviceError if it cannot listen for the robot
  ServojDrive(std::vector<DrivenJoint> joints, const ServojDriveSettings& settings);
  /// Brakes along the path, and ends the program on the robot.
  ~ServojDrive();
  ServojDrive(const ServojDrive&) = delete;
  ServojDrive& operator=(const ServojDrive&) = delete;

  /// Sends the program to the robot if there is no connection; to be called a few times a second. May block
  /// for half a second.
  /// @return why the robot is not ready, in words; empty if it is
  std::string keepConnected();
  /// Adds points, with times by `SteadyClock`.
  /// @throws Disconnected if no robot is connected; InvalidInput as `CyclicPlayer::accept`
  void accept(const TrajectoryChunk& chunk);
  /// Brakes along the path.
  void brake();
  ServojDriveState state() const;
  /// Whether its thread got real-time priority and locked memory, in words (`PeriodicThread::rights`).
  std::string rights() { return thread_->rights(); }
  /// TCP port to which the program on the robot connects.
  std::uint16_t port() const { return caller_.port(); }

 private:
  void cycle(double due_s);
  bool isReady() const { return link_.isOpen() && has_begun_; }

  SteadyClock clock_;
  ServojCaller caller_;
  double called_s_;  ///< time at which the program was last sent
  mutable InheritingMutex mutex_;
  ServojLink link_;
  CyclicPlayer player_;
  std::vector<DrivenJoint> joints_;
  bool has_begun_ = false;   ///< whether the robot has reported on this connection
  bool was_moving_ = false;  ///< whether the connection was lost in motion
  JointValues actual_;
  std::unique_ptr<PeriodicThread> thread_;  ///< declared last, since it uses the other members
};

}  // namespace lamina
