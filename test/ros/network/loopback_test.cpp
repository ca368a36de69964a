// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "network/loopback.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace {

/// A TCP socket that listens on a free port of an address.
class Listener {
 public:
  explicit Listener(in_addr_t address) : descriptor_(::socket(AF_INET, SOCK_STREAM, 0)) {
    at_.sin_family = AF_INET;
    at_.sin_addr.s_addr = htonl(address);
    EXPECT_EQ(::bind(descriptor_, reinterpret_cast<sockaddr*>(&at_), sizeof at_), 0);
    EXPECT_EQ(::listen(descriptor_, 1), 0);
    socklen_t size = sizeof at_;
    EXPECT_EQ(::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&at_), &size), 0);
  }
  ~Listener() { ::close(descriptor_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  bool hasFilter() const {
    socklen_t instructions = 0;
    EXPECT_EQ(::getsockopt(descriptor_, SOL_SOCKET, SO_GET_FILTER, nullptr, &instructions), 0);
    return instructions > 0;
  }

  bool isReachedByLoopback() const {
    sockaddr_in to = at_;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int client = ::socket(AF_INET, SOCK_STREAM, 0);
    const bool is_reached = ::connect(client, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0;
    ::close(client);
    return is_reached;
  }

 private:
  int descriptor_;
  sockaddr_in at_{};
};

TEST(Loopback, FiltersSocketsOnAllInterfacesAlone) {
  const Listener everywhere(INADDR_ANY);
  const Listener inside(INADDR_LOOPBACK);
  EXPECT_TRUE(lamina::closeToOtherHosts().empty());
  EXPECT_TRUE(everywhere.hasFilter());
  EXPECT_FALSE(inside.hasFilter());
  EXPECT_TRUE(everywhere.isReachedByLoopback());
  EXPECT_TRUE(inside.isReachedByLoopback());
}

/// ROS_IP of a node that is started with these; "" stands for none.
std::string addressWith(const char* address, const char* name, const char* master,
                        std::string argument = "") {
  address[0] == '\0' ? ::unsetenv("ROS_IP") : ::setenv("ROS_IP", address, 1);
  name[0] == '\0' ? ::unsetenv("ROS_HOSTNAME") : ::setenv("ROS_HOSTNAME", name, 1);
  master[0] == '\0' ? ::unsetenv("ROS_MASTER_URI") : ::setenv("ROS_MASTER_URI", master, 1);
  std::string program = "node";
  char* arguments[] = {program.data(), argument.data(), nullptr};
  lamina::stayOnLoopback(2, arguments);
  const char* set = ::getenv("ROS_IP");
  return set == nullptr ? "" : set;
}

TEST(Loopback, IsWhereANodeStaysUnlessItIsSetOtherwise) {
  EXPECT_EQ(addressWith("", "", ""), "127.0.0.1");
  EXPECT_EQ(addressWith("", "", "http://localhost:11311"), "127.0.0.1");
  EXPECT_EQ(addressWith("192.168.0.5", "", "http://localhost:11311"), "192.168.0.5");
  EXPECT_EQ(addressWith("", "robot", "http://localhost:11311"), "");
  EXPECT_EQ(addressWith("", "", "http://robot:11311"), "");
  EXPECT_EQ(addressWith("", "", "", "__master:=http://robot:11311"), "");
  EXPECT_EQ(addressWith("", "", "http://robot:11311", "__master:=http://127.0.0.1:11311"), "127.0.0.1");
}

}  // namespace
