// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "network/listening_ports.hpp"

#include <gtest/gtest.h>

namespace {

using lamina::ListeningPort;
using lamina::listeningPorts;

#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__  // of the texts below, which a kernel of such a host wrote

TEST(ListeningPorts, AreThoseOfSocketsThatListen) {
  const std::vector<ListeningPort> ports = listeningPorts(
      "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode\n"
      "   0: 00000000:819D 00000000:0000 0A 00000000:00000000 00:00000000 00000000     0        0 4711 1 0 "
      "100 0\n"
      "   1: 0100007F:2C2F 00000000:0000 0A 00000000:00000000 00:00000000 00000000  1000        0 4712 1 0 "
      "100 0\n"
      "   2: 0100007F:2C2F 0100007F:8001 01 00000000:00000000 00:00000000 00000000  1000        0 4713 1 0 "
      "20 4\n"
      "   3: 0500A8C0:0016 00000000:0000 0A 00000000:00000000 00:00000000 00000000     0        0 4714 1 0 "
      "100 0\n");
  ASSERT_EQ(ports.size(), 3U);
  EXPECT_EQ(ports[0].port, 33181);
  EXPECT_FALSE(ports[0].is_on_loopback);
  EXPECT_EQ(ports[0].inode, 4711U);
  EXPECT_EQ(ports[1].port, 11311);
  EXPECT_TRUE(ports[1].is_on_loopback);
  EXPECT_EQ(ports[2].port, 22);  // 192.168.0.5
  EXPECT_FALSE(ports[2].is_on_loopback);
}

bool isOnLoopback(const std::string& address) {
  const std::vector<ListeningPort> ports =
      listeningPorts(" 0: " + address + ":2C2F " + std::string(32, '0') +
                     ":0000 0A 00000000:00000000 00:00000000 00000000 1000 0 9 1 0 100 0\n");
  EXPECT_EQ(ports.size(), 1U) << address;
  return ports.at(0).is_on_loopback;
}

TEST(ListeningPorts, KnowTheLoopbackInterfaceInAddressesOfVersion6) {
  EXPECT_TRUE(isOnLoopback("00000000000000000000000001000000"));   // ::1
  EXPECT_TRUE(isOnLoopback("0000000000000000FFFF00000100007F"));   // ::ffff:127.0.0.1
  EXPECT_FALSE(isOnLoopback("0000000000000000FFFF00000500A8C0"));  // ::ffff:192.168.0.5
  EXPECT_FALSE(isOnLoopback("00000000000000000000000000000000"));  // ::
  EXPECT_FALSE(isOnLoopback("000080FE000000000000000001000000"));  // fe80::1
}

#endif

TEST(ListeningPorts, AreNoneInLinesOfAnotherForm) {
  EXPECT_TRUE(listeningPorts("").empty());
  EXPECT_TRUE(listeningPorts("what is this\n").empty());
  EXPECT_TRUE(listeningPorts(" 0: 00000000 0 0A 0 0 0 0 0 9 1\n").empty());
  EXPECT_TRUE(listeningPorts(" 0: 0000:2C2F 0 0A 0 0 0 0 0 9 1\n").empty());
  EXPECT_TRUE(listeningPorts(" 0: 0000000Z:2C2F 0 0A 0 0 0 0 0 9 1\n").empty());
  EXPECT_TRUE(listeningPorts(" 0: 00000000:12C2F 0 0A 0 0 0 0 0 9 1\n").empty());
}

}  // namespace
