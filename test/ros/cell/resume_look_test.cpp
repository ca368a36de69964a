// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/cell_controller/resume/resume_look.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

ExecutionProgress laid(double path_mm, std::uint64_t sent_through = 5) {
  return {sent_through, 3, 0, path_mm, 0.0};
}

TEST(ResumeLook, IsRefusedUntilItIsAnswered) {
  ResumeLook look("no answer");
  EXPECT_EQ(look.refusal(), "no answer");
  EXPECT_TRUE(look.outlook().is_by_place);
  const auto job = look.lookAt("a.csv", laid(12.0));
  ASSERT_TRUE(job);
  EXPECT_FALSE(look.lookAt("a.csv", laid(12.0))) << "one answer is awaited at a time";
  EXPECT_EQ(look.refusal(), "no answer");
  look.answer(*job, {"", {true, "it begins after 10 mm"}});
  EXPECT_EQ(look.refusal(), "");
  EXPECT_EQ(look.outlook().text, "it begins after 10 mm");
  ASSERT_TRUE(look.lookAt("a.csv", laid(12.0))) << "where it stands may have become another place";
  EXPECT_EQ(look.outlook().text, "it begins after 10 mm") << "until then the last answer holds";
}

TEST(ResumeLook, DropsAnAnswerToTheJobBefore) {
  ResumeLook look("no answer");
  const auto before = look.lookAt("a.csv", laid(12.0));
  ASSERT_TRUE(before);
  EXPECT_FALSE(look.lookAt("b.csv", laid(40.0)));
  look.answer(*before, {"", {true, "it begins after 10 mm"}});
  EXPECT_EQ(look.refusal(), "no answer");
  EXPECT_EQ(look.outlook().text, "");
  const auto now = look.lookAt("b.csv", laid(40.0));
  ASSERT_TRUE(now) << "it can be asked for again";
  look.answer(*now, {"the machine still moves", {true, ""}});
  EXPECT_EQ(look.refusal(), "the machine still moves");
}

/// Also where another job was asked for: the driver knows nothing of this one.
TEST(ResumeLook, BeginsAnewWhatWasNotHandedOver) {
  ResumeLook look("no answer");
  const auto before = look.lookAt("a.csv", laid(12.0));
  EXPECT_FALSE(look.lookAt("a.csv", laid(12.0, 0)));
  EXPECT_EQ(look.refusal(), "");
  EXPECT_EQ(look.outlook().text,
            "nothing of it was handed over, and nothing is laid: it begins anew, at its start");
  look.answer(*before, {"", {true, "it begins after 10 mm"}});
  EXPECT_NE(look.outlook().text.find("begins anew"), std::string::npos);
}

}  // namespace
}  // namespace lamina
