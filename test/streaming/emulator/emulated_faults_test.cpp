// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/emulator/emulated_faults.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(EmulatedFaults, AreReadAsRatesOrLines) {
  const Fault rate = faultFromText("lost_ok=0.25");
  EXPECT_EQ(rate.kind, FaultKind::LostOk);
  EXPECT_DOUBLE_EQ(rate.rate, 0.25);
  const Fault lines = faultFromText("corrupted_line=12,40");
  EXPECT_EQ(lines.kind, FaultKind::CorruptedLine);
  EXPECT_EQ(lines.lines, (std::vector<std::uint64_t>{12, 40}));
}

TEST(EmulatedFaults, AreRefusedWhenMalformed) {
  for (const char* text : {"lost_ok", "earthquake=0.1", "lost_ok=1.5", "lost_ok=-0.1",
                           "lost_ok=", "lost_ok=1,x", "lost_ok=0.1x"}) {
    EXPECT_THROW(faultFromText(text), InvalidConfig) << text;
  }
}

TEST(EmulatedFaults, KnowTheirNames) {
  for (const FaultKind kind : allFaultKinds()) {
    EXPECT_EQ(faultFromText(std::string(toString(kind)) + "=0.5").kind, kind);
  }
}

TEST(EmulatedFaults, StrikeAListedLineOnce) {
  FaultInjector injector({{FaultKind::LostOk, 0.0, {3}}}, 1);
  EXPECT_FALSE(injector.strikes(FaultKind::LostOk, 2));
  EXPECT_FALSE(injector.strikes(FaultKind::Reset, 3));
  EXPECT_TRUE(injector.strikes(FaultKind::LostOk, 3));
  EXPECT_FALSE(injector.strikes(FaultKind::LostOk, 3));
}

TEST(EmulatedFaults, StrikeAboutAsOftenAsTheirRate) {
  FaultInjector injector({{FaultKind::LostOk, 0.1, {}}}, 7);
  int struck = 0;
  for (std::uint64_t line = 0; line < 10000; ++line)
    struck += injector.strikes(FaultKind::LostOk, line) ? 1 : 0;
  EXPECT_NEAR(struck, 1000, 150);  // five standard deviations
}

TEST(EmulatedFaults, ChangeExactlyOneCharacter) {
  FaultInjector injector({}, 3);
  const std::string good = "N12 G1 X10.5*33";
  for (int i = 0; i < 1000; ++i) {
    const std::string bad = injector.corrupted(good);
    ASSERT_EQ(bad.size(), good.size());
    int changed = 0;
    for (std::size_t at = 0; at < good.size(); ++at) changed += bad[at] != good[at] ? 1 : 0;
    ASSERT_EQ(changed, 1) << bad;
  }
}

}  // namespace
}  // namespace lamina
