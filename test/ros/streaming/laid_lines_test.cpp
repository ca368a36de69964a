// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/gcode_streamer/laid_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "nodes/gcode_streamer/stream_messages.hpp"

namespace lamina {
namespace {

constexpr double kArea = M_PI;  // mm^2 of filament 2 mm thick

/// Three commands, a bead of 10 mm and one of 20 mm.
StreamableProgram twoBeadsOfLines(const std::string& end = "") {
  return StreamableProgram::fromText("beads",
                                     "; begins\nM83\nG1 X10 F600 E1 ; bead\n\n(stays)\nG1 Y20 E3\n" + end);
}

/// Sends each extruding line in two, of which the first one travels, and half of the filament.
class HalvedRevision final : public ProgramRevision {
 public:
  bool isKnown(std::int32_t /*layer*/) override { return true; }
  void decide(std::int32_t /*layer*/) override {}
  double waitTime() const override { return 0.0; }
  std::string revised(std::string_view line, std::uint64_t number) override {
    if (number == 2) return "; half of it\nG1 X5 F600\nG1 X10 E0.5";
    return std::string(line);
  }
};

TEST(LaidLines, CountWhatTheMachineHasAccepted) {
  LaidLines laid(twoBeadsOfLines(), nullptr, 2.0);
  EXPECT_EQ(laid.revision(), nullptr);
  EXPECT_EQ(laid.through(0).length(), 0.0);
  EXPECT_EQ(laid.through(1).length(), 0.0);
  EXPECT_NEAR(laid.through(2).length(), 10.0, 1e-9);
  EXPECT_NEAR(laid.through(1).length(), 10.0, 1e-9) << "nothing is taken back";
  EXPECT_NEAR(laid.through(3).length(), 30.0, 1e-9);
  EXPECT_NEAR(laid.through(99).volume(), 4.0 * kArea, 1e-9) << "no more than there are";
  // Of one that goes on after the second line.
  EXPECT_NEAR(LaidLines(twoBeadsOfLines(), nullptr, 2.0).through(3).length(), 30.0, 1e-9);
}

TEST(LaidLines, AreCountedOnLaterIfThereAreMany) {
  LaidLines laid(twoBeadsOfLines(), nullptr, 2.0);
  EXPECT_NEAR(laid.through(3, 2).length(), 10.0, 1e-9);
  EXPECT_NEAR(laid.through(3, 2).length(), 30.0, 1e-9);
}

TEST(LaidLines, GoByTheDiameterThatTheProgramStates) {
  LaidLines laid(twoBeadsOfLines("; filament_diameter = 4\n"), nullptr, 2.0);
  EXPECT_NEAR(laid.through(3).volume(), 4.0 * 4.0 * kArea, 1e-9);
}

TEST(LaidLines, CountTheLinesOfARevision) {
  LaidLines laid(twoBeadsOfLines(), std::make_shared<HalvedRevision>(), 2.0);
  const std::shared_ptr<ProgramRevision> revision = laid.revision();
  ASSERT_NE(revision, nullptr);
  EXPECT_EQ(revision->revised("M83", 1), "M83");
  EXPECT_NE(revision->revised("G1 X10 F600 E1", 2).find("half"), std::string::npos);
  EXPECT_EQ(laid.through(2).length(), 0.0);
  EXPECT_NEAR(laid.through(3).length(), 5.0, 1e-9);
  EXPECT_NEAR(laid.through(4).volume(), 0.5 * kArea, 1e-9) << "the fourth one was not given yet";
  revision->revised("G1 Y20 E3", 3);
  EXPECT_NEAR(laid.through(4).length(), 25.0, 1e-9);
}

TEST(LaidLines, AreReportedInMetresWithTheFeedOfTheLastOne) {
  LaidLines laid(twoBeadsOfLines(), nullptr, 2.0);
  StreamStatus status;
  status.state = PackmlState::Execute;
  const lamina_msgs::PrintProgress running = toPrintProgress(status, laid.through(3), "beads");
  EXPECT_EQ(running.job, "beads");
  EXPECT_NEAR(running.laid_length, 0.030, 1e-12);
  EXPECT_NEAR(running.laid_volume, 4e-9 * kArea, 1e-18);
  EXPECT_FLOAT_EQ(static_cast<float>(running.tip_speed), 0.01F);
  status.state = PackmlState::Held;
  EXPECT_EQ(toPrintProgress(status, laid.through(3), "beads").tip_speed, 0.0);
}

}  // namespace
}  // namespace lamina
