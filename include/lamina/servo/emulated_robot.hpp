// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "lamina/base/clock.hpp"
#include "lamina/base/random.hpp"
#include "lamina/servo/servoj_follower.hpp"
#include "lamina/servo/tcp_socket.hpp"

namespace lamina {

/// Parameters of a program by `servojProgram`.
struct SentProgram {
  std::string host;        ///< IPv4 address to which the program connects
  std::uint16_t port = 0;  ///< TCP port to which it connects
  ServojSettings settings;
};

/// Parses a program by `servojProgram`; nothing if the text is no such program, or not complete.
std::optional<SentProgram> sentProgram(const std::string& text);

/// Properties of an emulated robot.
struct EmulatedRobotSettings {
  std::uint16_t port = 0;  ///< on the loopback interface, at which it accepts programs; 0 for any free one
  double lag_s = 0.02;     ///< time constant of its joints
  double jitter_s = 0.0;   ///< greatest delay of targets
  double loss = 0.0;       ///< share of targets that are lost, 0 to 1
  std::uint64_t seed = 1;  ///< of jitter and loss
};

/// Emulates a robot of Universal Robots: accepts a program, connects back, and follows targets like the
/// program, in a thread of its own. It connects to addresses of the loopback interface only. If its thread is
/// late, its cycles are delayed, not caught up.
class EmulatedRobot {
 public:
  /// @param start  positions of the joints [rad]
  /// @throws DeviceError if it cannot listen
  EmulatedRobot(const EmulatedRobotSettings& settings, const JointValues& start);
  ~EmulatedRobot();
  EmulatedRobot(const EmulatedRobot&) = delete;
  EmulatedRobot& operator=(const EmulatedRobot&) = delete;

  /// TCP port at which it accepts programs.
  std::uint16_t port() const { return door_.port(); }
  /// Positions of its joints, and the state of its last program.
  ServojReport report() const;
  /// How its last program has followed targets.
  ServojFollowing following() const;
  /// Whether its joints are at rest.
  bool isAtRest() const;
  /// Ends its program, like the stop button of the robot.
  void stop();

 private:
  struct Late {
    double ready_s;
    CyclicTarget target;
  };
  void run();
  void awaitProgram();
  void runProgram(const SentProgram& program);
  void read(const TcpSocket& host, double now_s);
  bool isStopping() const;
  void waitUntil(double time_s) const;

  EmulatedRobotSettings settings_;
  SteadyClock clock_;
  Random random_;
  TcpSocket door_;
  mutable std::mutex mutex_;
  ServojFollower follower_;
  FrameCutter<TargetBytes> cutter_;
  std::deque<Late> late_;
  bool is_over_ = false;  ///< whether the host has closed the connection
  bool is_stopping_ = false;
  std::thread thread_;
};

}  // namespace lamina
