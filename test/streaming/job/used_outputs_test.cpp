// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/used_outputs.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

using GcodeLines = std::vector<std::string>;

TEST(UsedOutputs, AreSwitchedOffHoweverTheirCommandsAreWritten) {
  for (const auto& program : {GcodeLines{"M104 T1 S200", "M106 P2 S255", "M3 S100"},
                              GcodeLines{"M104T1S200", "M106P2S255", "M3S100"}}) {
    UsedOutputs outputs;
    for (const std::string& command : program) outputs.see(command);
    EXPECT_EQ(outputs.heatOff(), GcodeLines{"M104 T1 S0"});
    EXPECT_EQ(outputs.airOff(), GcodeLines{"M106 P2 S0"});
    EXPECT_EQ(outputs.beamOff(), GcodeLines{"M5"});
  }
}

}  // namespace
}  // namespace lamina
