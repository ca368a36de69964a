// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/threads/joint_progress.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lamina {
namespace {

class Heard final : public Progress {
 public:
  void report(const std::string& stage, double fraction) override {
    stages.push_back(stage);
    fractions.push_back(fraction);
  }
  bool isCancelled() const override { return is_cancelled; }

  std::vector<std::string> stages;
  std::vector<double> fractions;
  bool is_cancelled = false;
};

TEST(JointProgress, AddsUpWhatItsPartsHaveDone) {
  Heard heard;
  JointProgress joint(heard, "both");
  JointProgress::Part large(joint, 0.75);
  JointProgress::Part small(joint, 0.25);
  large.report("one", 0.5);
  small.report("other", 1.0);
  large.report("one", 1.0);
  EXPECT_EQ(heard.fractions, (std::vector<double>{0.375, 0.625, 1.0}));
  EXPECT_EQ(heard.stages, (std::vector<std::string>{"both", "both", "both"}));
}

TEST(JointProgress, NeverFallsAndSkipsStepsTooSmallToSee) {
  Heard heard;
  JointProgress joint(heard, "all");
  JointProgress::Part part(joint, 1.0);
  part.report("all", 0.5);
  part.report("all", 0.25);
  part.report("all", 0.5 + 1.0 / 256);
  part.report("all", 0.5625);
  EXPECT_EQ(heard.fractions, (std::vector<double>{0.5, 0.5625}));
}

TEST(JointProgress, IsCancelledAsTheWholeIs) {
  Heard heard;
  JointProgress joint(heard, "all");
  const JointProgress::Part part(joint, 1.0);
  EXPECT_FALSE(part.isCancelled());
  heard.is_cancelled = true;
  EXPECT_TRUE(part.isCancelled());
}

}  // namespace
}  // namespace lamina
