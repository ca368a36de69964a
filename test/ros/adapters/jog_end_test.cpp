// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/jog_end.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(JogEnd, IsWaitedForUntilTheMachineRests) {
  EXPECT_FALSE(isJogOver({false, false}, 0.0));
  EXPECT_FALSE(isJogOver({false, false}, 4.9));
  EXPECT_TRUE(isJogOver({true, false}, 0.0));
  EXPECT_TRUE(isJogOver({true, false}, 60.0)) << "nobody looked meanwhile";
}

TEST(JogEnd, IsNotWaitedForWhenTheJobIsStopped) {
  EXPECT_THROW(isJogOver({false, true}, 0.0), Cancelled);
  EXPECT_THROW(isJogOver({true, true}, 0.0), Cancelled) << "nor does the job begin";
}

TEST(JogEnd, BeginsNoJobOnAMachineThatDoesNotComeToRest) {
  try {
    isJogOver({false, false}, 5.1);
    FAIL() << "expected a refusal";
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("5.1 s"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamina
