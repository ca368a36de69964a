// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_link.hpp"

#include <array>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/servo/servoj_program.hpp"

namespace lamina {
namespace {

constexpr double kConnectWait = 0.5;  // s
constexpr std::size_t kPiece = 4096;  // bytes read at once

}  // namespace

ServojCaller::ServojCaller(const ServojSettings& settings, const RobotAddress& address)
    : settings_(settings),
      address_(address),
      door_(TcpSocket::listeningOn(address.bind, static_cast<std::uint16_t>(address.port))) {}

void ServojCaller::sendProgram() {
  script_ =
      TcpSocket::connectedTo(address_.host, static_cast<std::uint16_t>(address_.script_port), kConnectWait);
  if (!script_.send(servojProgram(settings_, address_.bind, port())))
    throw Disconnected("the robot at " + address_.host + " takes no program");
}

TcpSocket ServojCaller::called() {
  std::array<char, kPiece> ignored{};
  while (script_.isOpen() && script_.read(ignored.data(), ignored.size()).value_or(0) > 0) continue;
  TcpSocket caller = door_.accepted();
  if (caller.isOpen() && caller.peer() != address_.host) caller.close();
  if (caller.isOpen()) script_.close();
  return caller;
}

ServojLink::ServojLink(const ServojSettings& settings, double report_silence_s)
    : settings_(settings), report_silence_s_(report_silence_s) {}

void ServojLink::begin(TcpSocket socket, double now_s) {
  socket_ = std::move(socket);
  reader_ = ReportReader();
  heard_ = 0;
  heard_s_ = now_s;
  fault_ = nullptr;
}

void ServojLink::close(const char* why) {
  socket_.close();
  fault_ = why;
}

void ServojLink::read(double now_s) {
  if (!isOpen()) return;
  std::array<char, kPiece> bytes;
  for (;;) {
    const std::optional<std::size_t> count = socket_.read(bytes.data(), bytes.size());
    const bool is_over = !count;
    if (!is_over) reader_.add({bytes.data(), *count});
    if (reader_.isBroken()) return close("the robot sent what is no report");
    if (reader_.last() && reader_.last()->state == ServojState::Silent)
      return close("the robot heard nothing in time and has stopped");
    if (is_over || (reader_.last() && reader_.last()->state == ServojState::Ended))
      return close("the robot has ended its program");
    if (*count < bytes.size()) break;
  }
  if (reader_.count() != std::exchange(heard_, reader_.count())) heard_s_ = now_s;
  if (now_s - heard_s_ > report_silence_s_) close("the robot reports nothing");
}

void ServojLink::send(const CyclicTarget& target) {
  const TargetBytes bytes = targetBytes(target);
  if (isOpen() && !socket_.send({bytes.data(), bytes.size()})) close("the robot takes no targets");
}

void ServojLink::stop() {
  const TargetBytes bytes = endBytes();
  if (isOpen()) socket_.send({bytes.data(), bytes.size()});
  socket_.close();
}

}  // namespace lamina
