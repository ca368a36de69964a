// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/repeat_watch.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(RepeatWatch, ReportsOnceWhatHappensTooOften) {
  RepeatWatch watch(3, 60.0);
  EXPECT_FALSE(watch.add(0.0));
  EXPECT_FALSE(watch.add(1.0));
  EXPECT_FALSE(watch.add(2.0));
  EXPECT_FALSE(watch.add(60.5)) << "the first is too long ago";
  EXPECT_TRUE(watch.add(60.6));
  EXPECT_FALSE(watch.add(60.7)) << "counted anew";
}

}  // namespace
}  // namespace lamina
