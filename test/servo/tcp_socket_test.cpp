// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/tcp_socket.hpp"

#include <gtest/gtest.h>

#include <array>

#include "lamina/base/error.hpp"
#include "servo/soon.hpp"

namespace lamina::test {
namespace {

TEST(TcpSocket, CarriesBytesAndReportsWhenTheOtherEndHasGone) {
  const TcpSocket door = TcpSocket::listeningOn("127.0.0.1", 0);
  EXPECT_FALSE(door.accepted().isOpen());
  TcpSocket one = TcpSocket::connectedTo("127.0.0.1", door.port(), 1.0);
  TcpSocket other;
  ASSERT_TRUE(isSoon([&] { return (other = door.accepted()).isOpen(); }));
  std::array<char, 8> bytes{};
  EXPECT_EQ(other.read(bytes.data(), bytes.size()), 0U) << "nothing has come";
  ASSERT_TRUE(one.send("abc"));
  std::string heard;
  ASSERT_TRUE(isSoon([&] {
    heard.append(bytes.data(), other.read(bytes.data(), bytes.size()).value_or(0));
    return heard.size() == 3;
  }));
  EXPECT_EQ(heard, "abc");
  EXPECT_EQ(other.peer(), "127.0.0.1");
  one.close();
  EXPECT_FALSE(one.isOpen());
  EXPECT_TRUE(isSoon([&] { return !other.read(bytes.data(), bytes.size()); }));
}

TEST(TcpSocket, TakesNoMoreThanTheOtherEndReads) {
  const TcpSocket door = TcpSocket::listeningOn("127.0.0.1", 0);
  const TcpSocket one = TcpSocket::connectedTo("127.0.0.1", door.port(), 1.0);
  const std::string much(1U << 20U, 'x');
  bool was_refused = false;
  for (int i = 0; i < 100 && !was_refused; ++i) was_refused = !one.send(much);
  EXPECT_TRUE(was_refused) << "it does not wait";
}

TEST(TcpSocket, NamesWhatItCannotReach) {
  try {
    TcpSocket::connectedTo("127.0.0.1", 1, 1.0);
    FAIL() << "nothing listens there";
  } catch (const Disconnected& error) {
    EXPECT_NE(std::string(error.what()).find("nothing answers at 127.0.0.1:1"), std::string::npos);
  }
  EXPECT_THROW(TcpSocket::connectedTo("robot", 1, 1.0), InvalidConfig);
  const TcpSocket door = TcpSocket::listeningOn("127.0.0.1", 0);
  EXPECT_THROW(TcpSocket::listeningOn("127.0.0.1", door.port()), DeviceError);
  EXPECT_THROW(TcpSocket::listeningOn("192.0.2.1", 0), DeviceError);
}

}  // namespace
}  // namespace lamina::test
