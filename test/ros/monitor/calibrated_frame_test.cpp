// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/calibrated_frame.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(CalibratedFrame, IsThatOfTheSensorOrElseTheFirst) {
  CalibratedFrame frame;
  EXPECT_FALSE(frame.is("left")) << "no cloud has come";
  EXPECT_TRUE(frame.see("left"));
  EXPECT_FALSE(frame.see("right"));
  EXPECT_TRUE(frame.see("/left"));
  EXPECT_TRUE(frame.see("/sensor")) << "as drivers from before tf2 write it";
  EXPECT_TRUE(frame.is("sensor"));
  EXPECT_FALSE(frame.see("left"));
  EXPECT_FALSE(frame.is("left"));
}

}  // namespace
}  // namespace lamina
