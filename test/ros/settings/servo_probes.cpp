// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Robots that take a target each cycle.
#include <chrono>
#include <thread>

#include "lamina/base/error.hpp"
#include "lamina/servo/servoj_drive.hpp"
#include "lamina/servo/servoj_program.hpp"
#include "nodes/servo_bridge/bridge_settings.hpp"
#include "ros/settings/node_probes.hpp"
#include "servo/servo_arm.hpp"
#include "servo/soon.hpp"

namespace lamina::test {
namespace {

constexpr double kServoCycle = 0.01;  // s

class SinkOfNothing final : public CyclicSink {
 public:
  double cycle() const override { return kServoCycle; }
  double ahead() const override { return 0.05; }
  void send(const CyclicTarget&) override {}
  void stop() override {}
};

/// A motion by 1 rad/s of which the hundredth cycle comes 45 ms late; it is braked at 1.5 s.
std::string ledLate(const SettingTexts& set) {
  CyclicPlayer player(sixJoints(), settingsWith<ServoBridgeSettings>(set).drive.cyclic, SinkOfNothing());
  player.begin(sixValues(0.0));
  player.accept(sampledChunk(steadily, 0.0, 2.0, 0.1), 0.0);
  for (int i = 0; i < 300; ++i) {
    if (i == 150) player.brake();
    player.advance(kServoCycle * i, kServoCycle * i + (i == 100 ? 0.045 : 0.0));
  }
  return numbersText({player.target().now.position[0]});
}

/// Whether a motion is taken whose first point is half a degree off.
std::string takenFromAside(const SettingTexts& set) {
  CyclicPlayer player(sixJoints(), settingsWith<ServoBridgeSettings>(set).drive.cyclic, SinkOfNothing());
  player.begin(sixValues(0.0));
  try {
    player.accept({{jointPoint(0.5, sixValues(0.009), sixValues(0.0)),
                    jointPoint(2.0, sixValues(1.0), sixValues(0.0))}},
                  0.0);
    return "taken";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

std::string programOfRobot(const SettingTexts& set) {
  const ServojDriveSettings drive = settingsWith<ServoBridgeSettings>(set).drive;
  return servojProgram(drive.servoj, drive.robot.bind, static_cast<std::uint16_t>(drive.robot.port));
}

/// What is said of a robot that takes its program on a port of this host and does not call back.
std::string called(const SettingTexts& set) {
  static const TcpSocket scripts = TcpSocket::listeningOn("127.0.0.1", 0);
  ServojDriveSettings settings = settingsWith<ServoBridgeSettings>(set).drive;
  if (settings.robot.script_port == RobotAddress().script_port) settings.robot.script_port = scripts.port();
  std::string said;
  try {
    ServojDrive drive(sixJoints(), settings);
    said = drive.keepConnected() + (drive.port() == settings.robot.port ? " on this port" : "");
  } catch (const DeviceError& error) {
    said = error.what();
  }
  return said.substr(0, said.find(std::to_string(scripts.port())));
}

/// Whether a robot that reports once, and then no more, is there for longer.
std::string isHeardOf(const SettingTexts& set) {
  const TcpSocket scripts = TcpSocket::listeningOn("127.0.0.1", 0);
  ServojDriveSettings settings = settingsWith<ServoBridgeSettings>(set).drive;
  settings.robot.script_port = scripts.port();
  settings.robot.port = 0;
  ServojDrive drive(sixJoints(), settings);
  drive.keepConnected();
  const TcpSocket robot = TcpSocket::connectedTo("127.0.0.1", drive.port(), 1.0);
  const ReportBytes report = reportBytes({ServojState::Following, 1, sixValues(0.1)});
  robot.send({report.data(), report.size()});
  if (!isSoon([&] { return drive.keepConnected().empty(); })) return "";
  if (settings.robot.report_silence_s < 1.0)
    return isSoon([&] { return !drive.state().is_connected; }) ? "lost" : "there";
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  return drive.state().is_connected ? "there" : "lost";
}

}  // namespace

std::vector<SettingProbe> servoProbes() {
  return {
      {"a motion of which a cycle comes late",
       "",
       ledLate,
       {{"cyclic.late_cycles=50"}, {"cyclic.brake_s=1", "cyclic.late_cycles=50"}}},
      {"a motion from aside", "", takenFromAside, {{"cyclic.start_tolerance_deg=1"}}},
      {"the program of a robot",
       "",
       programOfRobot,
       {{"servoj.controller=cb3"},
        {"servoj.lookahead_s=0.05"},
        {"servoj.gain=600"},
        {"servoj.silence_s=0.4"},
        {"servoj.stop_rad_s2=4"}}},
      {"a robot that is called",
       "robot.port=0",
       called,
       {{"robot.host=127.0.0.2"}, {"robot.script_port=1"}, {"robot.bind=192.0.2.1"}, {"robot.port=50123"}}},
      {"a robot that falls silent",
       "robot.report_silence_s=60",
       isHeardOf,
       {{"robot.report_silence_s=0.02"}}}};
}

}  // namespace lamina::test
