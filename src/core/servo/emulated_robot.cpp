// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/emulated_robot.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <regex>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/loopback.hpp"

namespace lamina {
namespace {

constexpr double kLookForProgram = 0.01;        // s
constexpr double kCallWait = 1.0;               // s
constexpr std::size_t kLongestProgram = 65536;  // bytes
constexpr char kProgramEnd[] = "\nend\n";

/// The number behind "NAME = "; nothing if there is none.
std::optional<double> constantOf(const std::string& text, const std::string& name) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex("\\b" + name + " = ([0-9]{1,6}(?:\\.[0-9]{1,9})?)\n")))
    return std::nullopt;
  return std::stod(found[1].str());
}

}  // namespace

std::optional<SentProgram> sentProgram(const std::string& text) {
  const std::size_t end = sizeof kProgramEnd - 1;
  if (text.size() < end || text.compare(text.size() - end, end, kProgramEnd) != 0) return std::nullopt;
  std::smatch call;
  const std::regex calls("socket_open\\(\"([0-9.]{7,15})\", ([0-9]{1,5}), \"lamina\"\\)");
  const auto cycle_s = constantOf(text, "CYCLE");
  const auto silent_cycles = constantOf(text, "SILENT_CYCLES");
  const auto stop = constantOf(text, "STOP");
  if (!std::regex_search(text, call, calls) || !cycle_s || !silent_cycles || !stop) return std::nullopt;
  SentProgram program;
  program.host = call[1].str();
  const int port = std::stoi(call[2].str());
  if (port > std::numeric_limits<std::uint16_t>::max()) return std::nullopt;
  program.port = static_cast<std::uint16_t>(port);
  program.settings.controller = *cycle_s > 0.005 ? ServojController::Cb3 : ServojController::ESeries;
  program.settings.silence_s = *silent_cycles * *cycle_s;
  program.settings.stop_rad_s2 = *stop;
  return program;
}

EmulatedRobot::EmulatedRobot(const EmulatedRobotSettings& settings, const JointValues& start)
    : settings_(settings),
      random_(settings.seed),
      door_(TcpSocket::listeningOn("127.0.0.1", settings.port)),
      follower_({}, settings.lag_s, start),
      thread_([this] { run(); }) {}

EmulatedRobot::~EmulatedRobot() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_stopping_ = true;
  }
  thread_.join();
}

ServojReport EmulatedRobot::report() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return follower_.report();
}

ServojFollowing EmulatedRobot::following() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return follower_.following();
}

bool EmulatedRobot::isAtRest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return follower_.isAtRest();
}

void EmulatedRobot::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  follower_.end();
}

bool EmulatedRobot::isStopping() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_stopping_;
}

void EmulatedRobot::waitUntil(double time_s) const {
  const double wait_s = time_s - clock_.now();
  if (wait_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
}

void EmulatedRobot::run() {
  while (!isStopping()) {
    awaitProgram();
    waitUntil(clock_.now() + kLookForProgram);
  }
}

/// Takes one program, if one comes, and runs it to its end.
void EmulatedRobot::awaitProgram() {
  const TcpSocket sender = door_.accepted();
  if (!sender.isOpen()) return;
  std::string text;
  std::array<char, 4096> piece;
  while (!isStopping() && text.size() < kLongestProgram) {
    const std::optional<std::size_t> count = sender.read(piece.data(), piece.size());
    if (!count) break;
    text.append(piece.data(), *count);
    if (const auto program = sentProgram(text)) return runProgram(*program);
    if (*count == 0) waitUntil(clock_.now() + kLookForProgram);
  }
}

void EmulatedRobot::runProgram(const SentProgram& program) {
  if (!isLoopbackHost(program.host)) return;
  TcpSocket host;
  try {
    host = TcpSocket::connectedTo(program.host, program.port, kCallWait);
  } catch (const DeviceError&) {
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    follower_ = ServojFollower(program.settings, settings_.lag_s, follower_.position());
    cutter_ = {};
    late_.clear();
    is_over_ = false;
  }
  const double cycle_s = program.settings.cycle();
  for (double due_s = clock_.now();; due_s = std::max(due_s + cycle_s, clock_.now())) {
    waitUntil(due_s);
    const std::lock_guard<std::mutex> lock(mutex_);
    read(host, clock_.now());
    follower_.cycle();
    const ServojReport report = follower_.report();
    const ReportBytes bytes = reportBytes(report);
    if (!host.send({bytes.data(), bytes.size()})) is_over_ = true;
    const bool has_ended = report.state == ServojState::Silent || report.state == ServojState::Ended;
    if (is_stopping_ || (has_ended && follower_.isAtRest())) return;
    if (is_over_ && report.state == ServojState::Waiting) return;
  }
}

/// Takes what has come, each target as late as the jitter has it.
void EmulatedRobot::read(const TcpSocket& host, double now_s) {
  std::array<char, 4096> piece;
  while (!is_over_) {
    const std::optional<std::size_t> count = host.read(piece.data(), piece.size());
    if (!count) is_over_ = true;
    if (count.value_or(0) == 0) break;
    cutter_.add({piece.data(), *count}, [this, now_s](const TargetBytes& bytes) {
      const TargetFrame frame = targetOf(bytes);
      if (frame.kind == TargetFrame::Kind::End) follower_.end();
      if (frame.kind == TargetFrame::Kind::Target && random_.uniform(0.0, 1.0) >= settings_.loss)
        late_.push_back({now_s + random_.uniform(0.0, settings_.jitter_s), frame.target});
      return true;
    });
  }
  while (!late_.empty() && late_.front().ready_s <= now_s) {
    follower_.hear(late_.front().target);
    late_.pop_front();
  }
}

}  // namespace lamina
