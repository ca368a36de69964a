// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "network/former_port.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

/// The port at which a server can be opened as roscpp opens its own, of that number or of any (0); 0 if it
/// cannot.
std::uint16_t portOfServer(std::uint16_t wanted) {
  const int server = ::socket(AF_INET, SOCK_STREAM, 0);
  const int on = 1;
  ::setsockopt(server, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_ANY);
  place.sin_port = htons(wanted);
  socklen_t size = sizeof place;
  const bool is_open = ::bind(server, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0 &&
                       ::listen(server, 1) == 0 &&
                       ::getsockname(server, reinterpret_cast<sockaddr*>(&place), &size) == 0;
  ::close(server);
  return is_open ? ntohs(place.sin_port) : 0;
}

TEST(HeldPort, IsGivenToNobodyAsLongAsItIsHeld) {
  const std::uint16_t port = portOfServer(0);
  ASSERT_NE(port, 0);
  {
    const lamina::HeldPort held(port);
    EXPECT_TRUE(held.isHeld());
    EXPECT_EQ(portOfServer(port), 0);
  }
  EXPECT_EQ(portOfServer(port), port);
}

TEST(HeldPort, LeavesAPortThatIsInUse) {
  const std::uint16_t port = portOfServer(0);
  const lamina::HeldPort in_use(port);
  ASSERT_TRUE(in_use.isHeld());
  { EXPECT_FALSE(lamina::HeldPort(port).isHeld()); }
  EXPECT_EQ(portOfServer(port), 0) << "it is still in use";
}

}  // namespace
