// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/servo/cyclic_sink.hpp"
#include "lamina/servo/servoj_frames.hpp"
#include "lamina/servo/servoj_settings.hpp"
#include "lamina/servo/tcp_socket.hpp"

namespace lamina {

/// Sends the program to a robot, and waits for it to call back.
class ServojCaller {
 public:
  /// Listens from then on.
  /// @throws InvalidConfig, DeviceError as `TcpSocket::listeningOn`
  ServojCaller(const ServojSettings& settings, const RobotAddress& address);

  /// The port on which the robot is awaited.
  std::uint16_t port() const { return door_.port(); }
  /// @throws Disconnected if the robot takes no program
  void sendProgram();
  /// The robot that has called; closed if none has. Others than the robot are turned away.
  TcpSocket called();

 private:
  ServojSettings settings_;
  RobotAddress address_;
  TcpSocket door_;
  TcpSocket script_;  ///< open until the robot calls: a connection that is closed with bytes unread is reset
};

/// The connection to the program on a robot.
class ServojLink final : public CyclicSink {
 public:
  ServojLink(const ServojSettings& settings, double report_silence_s);

  /// Takes a connection, of which nothing has been read.
  void begin(TcpSocket socket, double now_s);
  bool isOpen() const { return socket_.isOpen(); }
  /// Reads what the robot reports. Closes the connection if it has ended, or reports nothing in time.
  void read(double now_s);
  /// The last report of this connection; nothing before the first.
  const std::optional<ServojReport>& report() const { return reader_.last(); }
  /// Why the last connection has ended; null while it is open, and before the first.
  const char* fault() const { return fault_; }

  double cycle() const override { return settings_.cycle(); }
  double ahead() const override { return settings_.ahead(); }
  void send(const CyclicTarget& target) override;
  void stop() override;

 private:
  void close(const char* why);

  ServojSettings settings_;
  double report_silence_s_;
  TcpSocket socket_;
  ReportReader reader_;
  std::size_t heard_ = 0;
  double heard_s_ = 0.0;
  const char* fault_ = nullptr;
};

}  // namespace lamina
