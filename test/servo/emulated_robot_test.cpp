// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/emulated_robot.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "lamina/servo/servoj_program.hpp"
#include "servo/servo_arm.hpp"
#include "servo/soon.hpp"

namespace lamina::test {
namespace {

/// What the robot has reported; nothing if it has closed.
std::optional<ServojReport> reported(const TcpSocket& robot, ReportReader& reader) {
  std::array<char, 4096> bytes;
  const auto count = robot.read(bytes.data(), bytes.size());
  if (!count) return std::nullopt;
  reader.add({bytes.data(), *count});
  return reader.last() ? reader.last() : ServojReport{};
}

TEST(EmulatedRobot, CallsBackAndReportsWhereItIs) {
  EmulatedRobot robot({}, sixValues(0.25));
  const TcpSocket door = TcpSocket::listeningOn("127.0.0.1", 0);
  const TcpSocket sender = TcpSocket::connectedTo("127.0.0.1", robot.port(), 1.0);
  ASSERT_TRUE(sender.send(servojProgram({}, "127.0.0.1", door.port())));
  TcpSocket called;
  ASSERT_TRUE(isSoon([&] { return (called = door.accepted()).isOpen(); }));
  EXPECT_EQ(called.peer(), "127.0.0.1");
  ReportReader reader;
  ASSERT_TRUE(isSoon([&] { return reported(called, reader) && reader.count() > 5; }));
  EXPECT_EQ(reader.last()->state, ServojState::Waiting);
  EXPECT_NEAR(reader.last()->position[0], 0.25, 1e-6);
  const TargetBytes end = endBytes();
  ASSERT_TRUE(called.send({end.data(), end.size()}));
  EXPECT_TRUE(isSoon([&] { return !reported(called, reader); })) << "it ends";
  EXPECT_EQ(reader.last()->state, ServojState::Ended);
}

TEST(EmulatedRobot, CallsNoOtherHost) {
  EmulatedRobot robot({}, sixValues(0.0));
  const TcpSocket sender = TcpSocket::connectedTo("127.0.0.1", robot.port(), 1.0);
  ASSERT_TRUE(sender.send(servojProgram({}, "192.0.2.1", 9)));
  std::array<char, 16> bytes;
  EXPECT_TRUE(isSoon([&] { return !sender.read(bytes.data(), bytes.size()); })) << "it lets the sender go";
}

}  // namespace
}  // namespace lamina::test
