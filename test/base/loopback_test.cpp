// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/loopback.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(Loopback, KnowsNamesAndAddressesOfTheLoopbackInterface) {
  for (const char* host :
       {"localhost", "127.0.0.1", "127.8.9.1", "::1", "[::1]", "0:0:0:0:0:0:0:1", "::ffff:127.0.0.1"})
    EXPECT_TRUE(isLoopbackHost(host)) << host;
}

TEST(Loopback, TakesNoOtherHostForIt) {
  for (const char* host : {"", "robot", "192.168.1.2", "::", "0.0.0.0", "::ffff:10.0.0.1", "1270.0.0.1",
                           "127.0.0.1.example.org", "localhost.example.org"})
    EXPECT_FALSE(isLoopbackHost(host)) << host;
}

}  // namespace
}  // namespace lamina
