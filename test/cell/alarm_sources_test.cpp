// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/alarm_sources.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(AlarmSources, EndAnAlarmWhenItHasEndedForAll) {
  AlarmSources sources;
  sources.raise({2201, "cell_controller", 0.0, "gives no sign of life"});
  sources.raise({2201, "host_watch of motion", 0.0, "has died"});
  sources.raise({2204, "host_watch of motion", 0.0, "is not stopped"});
  const auto first = sources.end(2201, "cell_controller");
  ASSERT_TRUE(first);
  EXPECT_FALSE(first->is_over);
  EXPECT_FALSE(first->other) << "what was raised last is shown already";
  EXPECT_TRUE(sources.isRaised(2201));
  const auto second = sources.end(2201, "host_watch of motion");
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->is_over);
  EXPECT_FALSE(sources.isRaised(2201));
  EXPECT_TRUE(sources.isRaised(2204));
}

TEST(AlarmSources, ShowTheCauseThatIsLeft) {
  AlarmSources sources;
  sources.raise({2201, "cell_controller", 1.5, "gives no sign of life"});
  sources.raise({2201, "host_watch of motion", 0.0, "has died"});
  const auto ended = sources.end(2201, "host_watch of motion");
  ASSERT_TRUE(ended && ended->other);
  EXPECT_FALSE(ended->is_over);
  EXPECT_EQ(ended->other->message, "gives no sign of life");
  EXPECT_EQ(ended->other->value, 1.5);
}

TEST(AlarmSources, LeaveWhatOthersHaveRaised) {
  AlarmSources sources;
  sources.raise({2201, "cell_controller", 0.0, "gives no sign of life"});
  EXPECT_FALSE(sources.end(2201, "host_watch of motion")) << "as it says when it is started";
  EXPECT_TRUE(sources.isRaised(2201));
  sources.raise({2201, "cell_controller", 0.0, "still gives none"});
  const auto ended = sources.end(2201, "cell_controller");
  ASSERT_TRUE(ended);
  EXPECT_TRUE(ended->is_over) << "a source that says it twice is one source";
  EXPECT_FALSE(sources.end(2201, "cell_controller"));
}

}  // namespace
}  // namespace lamina
