// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/base/threads/cycle_thread.hpp"
#include "lamina/base/threads/inheriting_mutex.hpp"
#include "lamina/servo/cyclic_player.hpp"
#include "lamina/servo/servoj_link.hpp"

namespace lamina {

/// Settings of a drive.
struct ServojDriveSettings {
  ServojSettings servoj;
  CyclicSettings cyclic;
  RobotAddress robot;
};

/// Adds the keys servoj.*, cyclic.* and robot.*.
void describe(SettingsSchema& schema, ServojDriveSettings& settings);

/// What a drive does at one instant.
struct ServojDriveState {
  bool is_connected = false;  ///< the robot has reported where it is
  bool is_at_rest = true;     ///< nothing is left to play
  JointValues actual;         ///< as the robot reports; of the last connection
  JointTarget wanted;
  std::string fault;  ///< why the last motion has ended early, in words; empty if it has not
};

/// Leads a robot of Universal Robots: sends it the program, and plays chunks to it in a thread of its own,
/// cycle by cycle. When the connection is lost the motion is given up, and the robot called again.
class ServojDrive {
 public:
  /// @throws InvalidConfig if the joints are not six rotary ones, or naming key, value and bound; DeviceError
  ServojDrive(std::vector<DrivenJoint> joints, const ServojDriveSettings& settings);
  /// Brakes along the path, and ends the program on the robot.
  ~ServojDrive();
  ServojDrive(const ServojDrive&) = delete;
  ServojDrive& operator=(const ServojDrive&) = delete;

  /// Calls the robot where there is no connection; to be called a few times a second. May wait half a second.
  /// @return what is wrong with the robot, in words; empty if nothing is
  std::string keepConnected();
  /// Takes points at times of `SteadyClock`.
  /// @throws Disconnected if there is no robot; InvalidInput as `CyclicPlayer::accept`
  void accept(const TrajectoryChunk& chunk);
  void brake();
  ServojDriveState state() const;
  /// The rights of its thread, in words.
  std::string rights() { return thread_->rights(); }
  /// The port on which the robot is awaited.
  std::uint16_t port() const { return caller_.port(); }

 private:
  void cycle(double due_s);
  bool isReady() const { return link_.isOpen() && has_begun_; }

  SteadyClock clock_;
  ServojCaller caller_;
  double called_s_;  ///< when the robot was called last
  mutable InheritingMutex mutex_;
  ServojLink link_;
  CyclicPlayer player_;
  std::vector<DrivenJoint> joints_;
  bool has_begun_ = false;   ///< the robot has reported on this connection
  bool was_moving_ = false;  ///< when the connection was lost
  JointValues actual_;
  std::unique_ptr<CycleThread> thread_;  ///< last: it uses the rest
};

}  // namespace lamina
