// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/gcode_streamer/stream_report.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lamina {
namespace {

using lamina_msgs::MachineState;

StreamStatus streamIn(PackmlState state, std::uint64_t lines_acknowledged = 0) {
  StreamStatus status;
  status.state = state;
  status.lines_acknowledged = lines_acknowledged;
  return status;
}

class StreamReportTest : public testing::Test {
 protected:
  /// "part: Starting" for each message.
  std::vector<std::string> said() const {
    std::vector<std::string> all;
    for (const MachineState& each : published_) all.push_back(each.job + ": " + each.state_name);
    return all;
  }

  std::vector<MachineState> published_;
  StreamReport report_{[this](const MachineState& state, const lamina_msgs::HeaterState& /*heaters*/) {
    published_.push_back(state);
  }};
};

TEST_F(StreamReportTest, LeavesOutWhatWasReadBeforeTheEnd) {
  report_.begin("part");
  report_.take(streamIn(PackmlState::Execute, 3));
  report_.take(streamIn(PackmlState::Complete, 9));
  EXPECT_FALSE(report_.take(streamIn(PackmlState::Execute, 8)).is_state);
  report_.publish();
  EXPECT_EQ(said(), (std::vector<std::string>{"part: Starting", "part: Execute", "part: Complete",
                                              "part: Complete"}));
  EXPECT_EQ(published_.back().lines_acknowledged, 9U);
  EXPECT_EQ(report_.status().state, PackmlState::Complete);
}

TEST_F(StreamReportTest, RepeatsNoEndUnderTheNameOfTheNextJob) {
  report_.begin("first");
  report_.take(streamIn(PackmlState::Complete, 9));
  report_.begin("second");
  report_.publish();
  report_.take(streamIn(PackmlState::Execute));
  EXPECT_EQ(said(), (std::vector<std::string>{"first: Starting", "first: Complete", "second: Starting",
                                              "second: Starting", "second: Execute"}));
  EXPECT_EQ(published_[2].lines_acknowledged, 0U);
}

/// What waits at the port may be read before the session begins.
TEST_F(StreamReportTest, NeverGoesBackToIdleWithinAJob) {
  report_.begin("part");
  EXPECT_FALSE(report_.take(streamIn(PackmlState::Idle)).is_state);
  report_.take(streamIn(PackmlState::Starting));
  report_.publish();
  report_.take(streamIn(PackmlState::Execute));
  EXPECT_EQ(said(), (std::vector<std::string>{"part: Starting", "part: Starting", "part: Execute"}));
}

TEST_F(StreamReportTest, PublishesOnlyAnotherState) {
  report_.begin("part");
  StreamStatus status = streamIn(PackmlState::Starting, 1);
  status.warning = "the laser stays on";
  status.position = ReportedPosition{1.0, 2.0, 3.0, 0.0};
  const StatusNews news = report_.take(status);
  EXPECT_FALSE(news.is_state);
  EXPECT_TRUE(news.is_warning);
  EXPECT_TRUE(news.is_position);
  const StatusNews again = report_.take(status);
  EXPECT_FALSE(again.is_warning || again.is_position);
  EXPECT_EQ(published_.size(), 1U);
}

TEST_F(StreamReportTest, StatesTheStepsAndTheNameThatHold) {
  report_.begin("part");
  lamina_msgs::StartupStep step;
  step.name = "home_x";
  EXPECT_TRUE(report_.takeSteps({step}).empty());
  EXPECT_EQ(report_.takeSteps({step, step}).size(), 1U);
  report_.rename("plan");
  report_.publish();
  EXPECT_EQ(published_.back().startup.size(), 2U);
  EXPECT_EQ(published_.back().job, "plan");
  EXPECT_EQ(report_.job(), "plan");
}

}  // namespace
}  // namespace lamina
