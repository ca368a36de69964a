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

/// What a program that was sent to a robot asks of it.
struct SentProgram {
  std::string host;  ///< that it calls back
  std::uint16_t port = 0;
  ServojSettings settings;
};

/// Reads what `servojProgram` wrote; nothing if the text is not such a program, whole.
std::optional<SentProgram> sentProgram(const std::string& text);

/// How a robot that is not there differs from a perfect one.
struct EmulatedRobotSettings {
  std::uint16_t port = 0;  ///< on which it takes programs, on the loopback interface; 0 for any that is free
  double lag_s = 0.02;     ///< time constant of its joints
  double jitter_s = 0.0;   ///< that targets come late at most
  double loss = 0.0;       ///< share of targets that never come
  std::uint64_t seed = 1;  ///< of both
};

/// A robot of Universal Robots that is not there: takes the program, calls back, and follows targets in a
/// thread of its own, as the program would. Within one host only: it calls no address but of the loopback
/// interface. Where its thread is late its own time stands still for so long.
class EmulatedRobot {
 public:
  /// @throws DeviceError if it cannot listen
  EmulatedRobot(const EmulatedRobotSettings& settings, const JointValues& start);
  ~EmulatedRobot();
  EmulatedRobot(const EmulatedRobot&) = delete;
  EmulatedRobot& operator=(const EmulatedRobot&) = delete;

  /// The port on which it takes programs.
  std::uint16_t port() const { return door_.port(); }
  /// Where its joints are, and what its last program does.
  ServojReport report() const;
  /// Of its last program.
  ServojFollowing following() const;
  /// Whether its joints stand still.
  bool isAtRest() const;
  /// Ends its program as its stop button would.
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
  bool is_over_ = false;  ///< the host has gone
  bool is_stopping_ = false;
  std::thread thread_;
};

}  // namespace lamina
