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

/// Sends the program to a robot, and accepts the connection that the program opens.
class ServojCaller {
 public:
  /// Listens for the connection from now on.
  /// @throws InvalidConfig, DeviceError as `TcpSocket::listeningOn`
  ServojCaller(const ServojSettings& settings, const RobotAddress& address);

  /// TCP port to which the program on the robot connects.
  std::uint16_t port() const { return door_.port(); }
  /// Sends the program to the robot.
  /// @throws InvalidConfig as `TcpSocket::connectedTo`
  /// @throws Disconnected if the robot accepts no program
  void sendProgram();
  /// The connection that the robot has opened; a closed socket if there is none. Connections from other
  /// addresses are closed.
  TcpSocket called();

 private:
  ServojSettings settings_;
  RobotAddress address_;
  TcpSocket door_;
  /// Connection by which the program was sent. It stays open until the robot connects, since closing it with
  /// unread bytes would reset it.
  TcpSocket script_;
};

/// The connection to the program on a robot: sends targets and reads reports.
class ServojLink final : public CyclicSink {
 public:
  /// @param report_silence_s  time without a report after which the connection is closed
  ServojLink(const ServojSettings& settings, double report_silence_s);

  /// Takes over a connection from which nothing has been read yet.
  void begin(TcpSocket socket, double now_s);
  bool isOpen() const { return socket_.isOpen(); }
  /// Reads the reports that have arrived. Closes the connection if the robot has ended the program or the
  /// connection, or sends no report in time.
  void read(double now_s);
  /// The last report on this connection; nothing before the first.
  const std::optional<ServojReport>& report() const { return reader_.last(); }
  /// Why the last connection was closed; null while one is open, and before the first.
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
