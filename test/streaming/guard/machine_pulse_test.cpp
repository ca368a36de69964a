// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/guard/machine_pulse.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lamina {
namespace {

TEST(MachinePulse, IsReadAsItWasSent) {
  const auto pulse =
      pulseIn(toText({true, {"tcp:printer.local:23", 250000}, "marlin", "/jobs/a b.gcode", true, true}));
  ASSERT_TRUE(pulse);
  EXPECT_TRUE(pulse->is_at_work);
  EXPECT_EQ(pulse->port.name, "tcp:printer.local:23");
  EXPECT_EQ(pulse->port.baud, 250000);
  EXPECT_EQ(pulse->firmware, "marlin");
  EXPECT_EQ(pulse->program, "/jobs/a b.gcode");
  EXPECT_TRUE(pulse->keeps_heaters_on);
  EXPECT_TRUE(pulse->has_job);
}

TEST(MachinePulse, OfNoProgramIsAPulse) {
  const auto pulse = pulseIn("lamina pulse 2\n0\n115200\n0\n0\nauto\n/dev/ttyUSB0\n\n");
  ASSERT_TRUE(pulse);
  EXPECT_FALSE(pulse->is_at_work);
  EXPECT_FALSE(pulse->has_job);
  EXPECT_EQ(pulse->program, "");
}

TEST(MachinePulse, KeepsToItsLines) {
  const auto pulse = pulseIn(toText({false, {"/dev/a\nb", 1}, "auto", "c\n1", false}));
  ASSERT_TRUE(pulse);
  EXPECT_EQ(pulse->port.name, "/dev/a b");
  EXPECT_EQ(pulse->program, "c 1");
}

TEST(MachinePulse, IsNotReadFromAnythingElse) {
  const std::string good = "lamina pulse 2\n1\n115200\n0\n1\nmarlin\n/dev/ttyUSB0\n/a\n";
  ASSERT_TRUE(pulseIn(good));
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(pulseIn(good.substr(0, size))) << good.substr(0, size);
  EXPECT_FALSE(pulseIn(good + "more\n"));
  EXPECT_FALSE(pulseIn("lamina pulse 3" + good.substr(14)));
  EXPECT_FALSE(pulseIn("lamina pulse 2\n2\n115200\n0\n1\nmarlin\n/dev/ttyUSB0\n/a\n"));
  EXPECT_FALSE(pulseIn("lamina pulse 2\n1\n115200\n0\n2\nmarlin\n/dev/ttyUSB0\n/a\n"));
  EXPECT_FALSE(pulseIn("lamina pulse 2\n1\n-1\n0\n1\nmarlin\n/dev/ttyUSB0\n/a\n"));
  EXPECT_FALSE(pulseIn("lamina pulse 2\n1\n99999999999\n0\n1\nmarlin\n/dev/ttyUSB0\n/a\n"));
  EXPECT_FALSE(pulseIn("lamina pulse 2\n1\n115200\n0\n1\nmarlin\n\n/a\n"));
  EXPECT_FALSE(pulseIn(good + std::string(kLongestPulse, 'x') + "\n"));
}

RC_GTEST_PROP(MachinePulseProperty, AnyBytesAreAPulseOrNone, (const std::string& bytes, unsigned at)) {
  std::string text = "lamina pulse 2\n1\n115200\n0\n1\nmarlin\n/dev/ttyUSB0\n/a\n";
  text.insert(at % (text.size() + 1), bytes);
  const auto pulse = pulseIn(text);
  if (!pulse) return;
  const auto again = pulseIn(toText(*pulse));
  RC_ASSERT(again.has_value());
  RC_ASSERT(again->port.name == pulse->port.name);
  RC_ASSERT(again->program == pulse->program);
  RC_ASSERT(again->is_at_work == pulse->is_at_work);
  RC_ASSERT(again->has_job == pulse->has_job);
}

TEST(ProtocolOfFirmware, IsTheOneThatSpeaksIt) {
  EXPECT_EQ(protocolOfFirmware("Marlin 2.1.2"), "marlin");
  EXPECT_EQ(protocolOfFirmware("A maker's own"), "marlin");
  EXPECT_EQ(protocolOfFirmware("Klipper"), "klipper");
  EXPECT_EQ(protocolOfFirmware("RepRapFirmware for Duet 3"), "reprapfirmware");
  EXPECT_EQ(protocolOfFirmware("grbl"), "grbl");
  EXPECT_EQ(protocolOfFirmware("Smoothieware"), "auto");
}

}  // namespace
}  // namespace lamina
