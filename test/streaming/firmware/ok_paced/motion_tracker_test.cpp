// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/motion_tracker.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

/// At the origin, with positions of axes absolute and of the filament relative.
MotionTracker trackerAtOrigin() {
  MotionTracker tracker;
  tracker.locate({0.0, 0.0, 0.0, 0.0});
  for (const char* mode : {"G90", "M83"}) {
    tracker.expect(mode);
    tracker.confirm();
  }
  return tracker;
}

TEST(MotionTracker, ShowsByThePositionWhetherALineWasRun) {
  for (const char* line : {"G1 X10 Y5 E2 F600", "G1X10Y5E2F600"}) {
    MotionTracker tracker = trackerAtOrigin();
    tracker.expect(line);
    EXPECT_EQ(tracker.evidence({10.0, 5.0, 0.0, 2.0}), RunEvidence::Ran) << line;
    EXPECT_EQ(tracker.evidence({0.0, 0.0, 0.0, 0.0}), RunEvidence::DidNotRun) << line;
    EXPECT_EQ(tracker.evidence({5.0, 2.5, 0.0, 1.0}), RunEvidence::None) << line;
    EXPECT_FALSE(tracker.isRepeatable()) << line << " twice would deposit twice";
    // Twice the longest way, at 10 mm/s.
    EXPECT_DOUBLE_EQ(tracker.seconds(), 2.0) << line;
  }
}

TEST(MotionTracker, TakesNoWordForTheExponentOfTheOneBefore) {
  MotionTracker tracker = trackerAtOrigin();
  tracker.expect("G1Y1E3");
  // With 1000 mm to go, that it stands at 1 would mean that it has not set out.
  EXPECT_EQ(tracker.evidence({0.0, 1.0, 0.0, 3.0}), RunEvidence::Ran);
}

}  // namespace
}  // namespace lamina
