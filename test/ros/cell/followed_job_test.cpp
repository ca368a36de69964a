// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/cell_controller/followed_job.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "names.hpp"
#include "nodes/cell_controller/driver_language.hpp"

namespace lamina {
namespace {

using lamina_msgs::Status;
using State = lamina_msgs::MachineState;

constexpr char kFile[] = "/cell/artefacts/3fa1";
const ros::Time kOrdered(1000.0);

State stateAt(std::uint8_t state, double stamp_s, std::uint32_t reached, const std::string& job = kFile) {
  State message;
  message.header.stamp = ros::Time(stamp_s);
  message.state = state;
  message.job = job;
  message.lines_total = 9;
  message.lines_sent = reached + 2;
  message.lines_acknowledged = reached;
  message.layer = 1;
  return message;
}

FollowedJob ordered(std::uint64_t order = 4) {
  FollowedJob job(driverLanguage());
  job.begin({kFile, ExecutionStart::Anew, order, "12@1"}, 5.0, kOrdered);
  job.takeUp(order);
  return job;
}

JobEnd endWith(std::uint8_t code, const std::string& message, std::uint64_t taken = 3) {
  Status status;
  status.code = code;
  status.message = message;
  return {code == Status::OK, "", status, taken};
}

TEST(FollowedJob, HasThePhaseOfItsNodesState) {
  const std::vector<std::pair<int, ExecutorPhase>> table = {{State::IDLE, ExecutorPhase::Resting},
                                                            {State::STARTING, ExecutorPhase::Starting},
                                                            {State::EXECUTE, ExecutorPhase::Running},
                                                            {State::HOLDING, ExecutorPhase::Pausing},
                                                            {State::HELD, ExecutorPhase::Paused},
                                                            {State::UNHOLDING, ExecutorPhase::Resuming},
                                                            {State::SUSPENDING, ExecutorPhase::Pausing},
                                                            {State::SUSPENDED, ExecutorPhase::Paused},
                                                            {State::COMPLETING, ExecutorPhase::Running},
                                                            {State::COMPLETE, ExecutorPhase::Done},
                                                            {State::STOPPING, ExecutorPhase::Stopping},
                                                            {State::STOPPED, ExecutorPhase::Resting},
                                                            {State::ABORTING, ExecutorPhase::Stopping},
                                                            {State::ABORTED, ExecutorPhase::Resting},
                                                            {State::CLEARING, ExecutorPhase::Stopping},
                                                            {State::RESETTING, ExecutorPhase::Stopping},
                                                            {16, ExecutorPhase::Resuming}};
  for (const auto& [state, phase] : table) {
    FollowedJob job = ordered();
    const auto report = job.hear(stateAt(static_cast<std::uint8_t>(state), 1000.1, 2));
    ASSERT_EQ(report.has_value(), !isAtRest(phase)) << state << ": what has ended may be the job before";
    if (!report) continue;
    EXPECT_EQ(report->phase, phase) << state;
    EXPECT_EQ(report->order, 4U);
    EXPECT_EQ(report->program, kFile);
    EXPECT_EQ(report->lines, 9U);
    EXPECT_EQ(report->progress.taken_through, 2U);
    EXPECT_EQ(report->progress.sent_through, 4U);
    EXPECT_EQ(report->progress.layer, 1);
  }
}

TEST(FollowedJob, RaisesTheAlarmOfWhatHasEndedADrive) {
  struct End {
    std::uint8_t code;
    std::string message;
    int alarm;
  };
  const std::vector<End> ends = {
      {Status::OK, "", 0},
      {Status::CANCELLED, "aborted on request", 0},
      {Status::CANCELLED, names::kNodeEnded, 2202},
      {Status::DISCONNECTED, "the controller has been silent for 1.02 s", 3101},
      {Status::TIMED_OUT, "no controller answers on 'follow_joint_trajectory' after 60 s", 3105},
      {Status::DEVICE_ERROR,
       std::string(names::kTipOff) + "7 mm from where it is to be; expected at most 5 mm", 4101},
      {Status::DEVICE_ERROR, std::string(names::kGoalEnded) + "REJECTED: joint_2 is unknown", 4103},
      {Status::DEVICE_ERROR, "ROS time went back by 3 s", 4106},
      {Status::INVALID_INPUT, "drops are not driven", 4105},
      {Status::INVALID_PROGRAM, "CSV line 3: a row needs 14 fields", 4105},
      {Status::FILE_ERROR, "/cell/artefacts/3fa1: no such file", 4105},
      {Status::UNREACHABLE, "layer 2, path 0, waypoint 3: joint_3 is at its limit", 4105},
      {Status::INTERNAL, "out of memory", 4106}};
  for (const End& end : ends) {
    FollowedJob job = ordered();
    job.hear(stateAt(State::EXECUTE, 1000.1, 2));
    const auto report = job.end(4, endWith(end.code, end.message));
    ASSERT_TRUE(report);
    EXPECT_EQ(report->alarm, end.alarm) << end.message;
    EXPECT_EQ(report->phase, end.code == Status::OK ? ExecutorPhase::Done : ExecutorPhase::Resting);
    EXPECT_EQ(report->failure, end.message);
    EXPECT_EQ(report->progress.taken_through, 3U) << "by the result, which the last state may come behind";
    EXPECT_FALSE(report->has_lost_motions);
    EXPECT_FALSE(job.isOrdered());
  }
}

// States come on a connection of their own: those of the job before may come behind the order.
TEST(FollowedJob, TakesNoStateOfTheJobBeforeForItsOwn) {
  FollowedJob job = ordered();
  EXPECT_FALSE(job.hear(stateAt(State::EXECUTE, 999.9, 8))) << "the same file, before the order";
  EXPECT_FALSE(job.hear(stateAt(State::EXECUTE, 1000.1, 8, "/cell/artefacts/other")));
  EXPECT_TRUE(job.isAwaited()) << "it can still be cancelled";
  const auto report = job.hear(stateAt(State::STARTING, 1000.2, 0));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->phase, ExecutorPhase::Starting);
  EXPECT_FALSE(job.isAwaited());
}

lamina_msgs::PrintProgress printed(double stamp_s, const std::string& job) {
  lamina_msgs::PrintProgress message;
  message.header.stamp = ros::Time(stamp_s);
  message.job = job;
  message.laid_length = 1.25;
  message.laid_volume = 3e-6;
  return message;
}

TEST(FollowedJob, HasWhatIsPrintedOfItAndOfNoOther) {
  FollowedJob job = ordered();
  for (const auto& other : {printed(999.9, kFile), printed(1000.1, "/cell/artefacts/other")}) {
    job.hear(other);
    const auto report = job.hear(stateAt(State::EXECUTE, 1000.2, 2));
    ASSERT_TRUE(report);
    EXPECT_EQ(report->progress.path_mm, 0.0);
    EXPECT_EQ(report->progress.deposited_mm3, 0.0);
  }
  job.hear(printed(1000.3, kFile));
  const auto report = job.hear(stateAt(State::EXECUTE, 1000.4, 2));
  ASSERT_TRUE(report);
  EXPECT_DOUBLE_EQ(report->progress.path_mm, 1250.0);
  EXPECT_DOUBLE_EQ(report->progress.deposited_mm3, 3000.0);
}

/// The same file is printed again, and fails before its first bead.
TEST(FollowedJob, EndsWithNothingThatWasPrintedByTheJobBefore) {
  for (const bool is_late : {false, true}) {
    FollowedJob job(driverLanguage());
    job.begin({kFile, ExecutionStart::Anew, 3, "11@1"}, 4.0, ros::Time(900.0));
    job.hear(stateAt(State::EXECUTE, 900.1, 2));
    if (!is_late) job.hear(printed(999.9, kFile));
    ASSERT_TRUE(job.end(3, endWith(Status::OK, "", 9)));
    job.begin({kFile, ExecutionStart::Anew, 4, "12@1"}, 5.0, kOrdered);
    if (is_late) job.hear(printed(999.9, kFile));
    job.hear(stateAt(State::STARTING, 1000.1, 0));
    const auto report = job.end(4, endWith(Status::DEVICE_ERROR, "process_io is not ready", 0));
    ASSERT_TRUE(report);
    EXPECT_EQ(report->order, 4U);
    EXPECT_EQ(report->progress.path_mm, 0.0) << is_late;
    EXPECT_EQ(report->progress.deposited_mm3, 0.0) << is_late;
  }
}

TEST(FollowedJob, EndsWithWhatWasPrintedOfIt) {
  FollowedJob job = ordered();
  job.hear(stateAt(State::EXECUTE, 1000.1, 2));
  job.hear(printed(1000.2, kFile));
  const auto report = job.end(4, endWith(Status::DISCONNECTED, "the controller has been silent"));
  ASSERT_TRUE(report);
  EXPECT_DOUBLE_EQ(report->progress.path_mm, 1250.0);
  EXPECT_DOUBLE_EQ(report->progress.deposited_mm3, 3000.0);
}

TEST(FollowedJob, HasReachedNothingIfItEndsBeforeItHasBegun) {
  FollowedJob job = ordered();
  job.hear(stateAt(State::COMPLETE, 999.9, 9));
  const auto report = job.end(4, endWith(Status::UNREACHABLE, "out of reach", 0));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->progress.taken_through, 0U);
  EXPECT_EQ(report->progress.sent_through, 0U);
  EXPECT_EQ(report->lines, 0U) << "the state was of the job before";
}

TEST(FollowedJob, EndsOnceWhateverComesBehind) {
  FollowedJob job = ordered();
  job.hear(stateAt(State::EXECUTE, 1000.1, 2));
  EXPECT_FALSE(job.end(3, endWith(Status::OK, ""))) << "of an earlier order";
  ASSERT_TRUE(job.end(4, endWith(Status::OK, "", 9)));
  EXPECT_FALSE(job.end(4, endWith(Status::OK, "", 9)));
  const auto late = job.hear(stateAt(State::EXECUTE, 1000.5, 8));
  ASSERT_TRUE(late);
  EXPECT_EQ(late->order, 0U) << "of no order";
}

TEST(FollowedJob, IsCutOffWhereItsNodeWasStartedAnew) {
  FollowedJob job = ordered();
  job.hear(stateAt(State::EXECUTE, 1000.1, 5));
  const auto report = job.hear(stateAt(State::IDLE, 1001.0, 0, ""));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->phase, ExecutorPhase::Resting);
  EXPECT_EQ(report->order, 4U);
  EXPECT_EQ(report->alarm, 2202);
  EXPECT_EQ(report->failure, "trajectory_driver was started anew; its job was cut off");
  EXPECT_EQ(report->progress.taken_through, 5U) << "of what is known";
  EXPECT_FALSE(job.isOrdered());
}

TEST(FollowedJob, IsAdoptedByItsState) {
  FollowedJob job(driverLanguage());
  EXPECT_FALSE(job.seen());
  const auto report = job.hear(stateAt(State::HELD, 900.0, 5));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->order, 0U);
  EXPECT_EQ(job.seen()->phase, ExecutorPhase::Paused);
  EXPECT_EQ(job.seen()->program, kFile);
  State failed = stateAt(State::ABORTED, 901.0, 5);
  failed.status.code = Status::DISCONNECTED;
  failed.status.message = "the controller has been silent";
  EXPECT_EQ(job.hear(failed)->alarm, 3101);
}

TEST(FollowedJob, WaitsForItsOrderToComeThrough) {
  FollowedJob job(driverLanguage());
  job.begin({kFile, ExecutionStart::Anew, 1, "12@1"}, 5.0, kOrdered);
  EXPECT_FALSE(job.takeUntaken(7.0, 2.0));
  EXPECT_TRUE(job.takeUntaken(7.1, 2.0));
  EXPECT_FALSE(job.takeUntaken(7.2, 2.0)) << "once";
  job.takeUp(2);
  EXPECT_TRUE(job.takeUntaken(9.2, 2.0)) << "another order was taken up";
  job.takeUp(1);
  EXPECT_FALSE(job.takeUntaken(100.0, 2.0)) << "its toolpath may be checked for minutes";
}

}  // namespace
}  // namespace lamina
