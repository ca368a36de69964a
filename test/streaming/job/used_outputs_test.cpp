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

GcodeLines heatOffAfter(const GcodeLines& program) {
  UsedOutputs outputs;
  for (const std::string& command : program) outputs.see(command);
  return outputs.heatOff();
}

/// Of a T command that was lost or refused, the program knows nothing.
TEST(UsedOutputs, SwitchOffEveryToolThatMayBeHot) {
  const GcodeLines both = {"M104 T0 S0", "M104 T1 S0"};
  EXPECT_EQ(heatOffAfter({"M104 T0 S200", "M104 T1 S190", "T1"}), both);
  EXPECT_EQ(heatOffAfter({"M104 S200", "T1", "M109 S190"}), both);
  EXPECT_EQ(heatOffAfter({"M104 T0 S200"}), GcodeLines{"M104 T0 S0"}) << "another tool may be active";
  EXPECT_EQ(heatOffAfter({"M104 S200"}), GcodeLines{}) << "the active one, as M104 S0 switches off";
}

}  // namespace
}  // namespace lamina
