// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_window.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(GrblWindow, HasRoomForItsCapacityAndForALineAlone) {
  GrblWindow window;
  window.setCapacity(10);
  EXPECT_TRUE(window.hasRoom(50));
  window.add({1, "G1X12"});  // and its end
  EXPECT_TRUE(window.hasRoom(4));
  EXPECT_FALSE(window.hasRoom(5));
  window.clear();
  EXPECT_TRUE(window.empty());
  window.add({2, "G1X12"});
  EXPECT_FALSE(window.hasRoom(5)) << "the capacity stays";
}

TEST(GrblWindow, CountsAnswersByThoseToQuestions) {
  GrblWindow window;
  EXPECT_NE(window.hearOk(), "") << "nothing was sent";
  EXPECT_EQ(window.hearAnswer(), "") << "somebody else's question";
  window.add({7, "G1X1"});
  window.add({0, "$G"});
  EXPECT_EQ(window.hearAnswer(), "a question behind line 7 was answered, the line was not");
  EXPECT_EQ(window.hearOk(), "");
  EXPECT_EQ(window.take().number, 7U);
  EXPECT_EQ(window.hearOk(), "an answer came more than lines were sent");
  EXPECT_EQ(window.hearAnswer(), "");
  EXPECT_EQ(window.hearOk(), "");
  EXPECT_EQ(window.take().number, 0U);
  EXPECT_FALSE(window.hasQuestion());
}

}  // namespace
}  // namespace lamina
