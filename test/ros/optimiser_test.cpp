// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Asks the running node optimiser to run studies, as a client would.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>

#include "lamina/base/atomic_file.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "request_settings.hpp"
#include "support/scratch_folder.hpp"
#include "wait_until.hpp"

namespace lamina {
namespace {

using lamina_msgs::Status;
using OptimiseClient = actionlib::SimpleActionClient<lamina_msgs::OptimiseAction>;
using OptimiseGoal = lamina_msgs::OptimiseGoal;
using OptimiseResult = lamina_msgs::OptimiseResult;

const ros::Duration kSearchPatience(test::kPatience);

const char* const kFront = R"(name: parabolas
variables: {x: [0, 4]}
commands:
  both: [awk, 'BEGIN {x = {x}; printf "{\"a\": %.9g, \"b\": %.9g}", x * x, (x - 2) * (x - 2)}']
responses:
  a: {command: both, pointer: /a}
  b: {command: both, pointer: /b}
objectives: {a: minimise, b: minimise}
search: {nsga2.population: 8, nsga2.generations: 2}
)";

class Optimiser : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(client_.waitForServer(kSearchPatience)); }

  OptimiseGoal goal(const std::string& study) const {
    OptimiseGoal goal;
    goal.study = study;
    goal.output = folder_.file("out");
    return goal;
  }

  OptimiseResult ask(const OptimiseGoal& goal) {
    client_.sendGoal(goal);
    EXPECT_TRUE(client_.waitForResult(kSearchPatience)) << "the node does not answer";
    return *client_.getResult();
  }

  OptimiseClient client_{names::kOptimise, true};
  test::ScratchFolder folder_;
};

TEST_F(Optimiser, RunsAStudyAndReportsHowFarItIs) {
  std::mutex mutex;
  lamina_msgs::OptimiseFeedback last;
  client_.sendGoal(goal(kFront), OptimiseClient::SimpleDoneCallback(), OptimiseClient::SimpleActiveCallback(),
                   [&](const lamina_msgs::OptimiseFeedbackConstPtr& feedback) {
                     const std::lock_guard<std::mutex> lock(mutex);
                     last = *feedback;
                   });
  ASSERT_TRUE(client_.waitForResult(kSearchPatience));
  const OptimiseResult result = *client_.getResult();
  ASSERT_EQ(result.status.code, Status::OK + 0) << result.status.message;
  EXPECT_EQ(result.failed, 0U);
  EXPECT_GT(result.front_size, 0U);
  EXPECT_EQ(result.chosen.rfind("x: ", 0), 0U) << result.chosen;
  EXPECT_TRUE(std::filesystem::exists(result.report));
  EXPECT_NE(readFile(result.report).find("parabolas"), std::string::npos);
  EXPECT_TRUE(test::waitUntil([&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return last.generation == 2U;
  })) << "of another topic than the result";
  const std::lock_guard<std::mutex> lock(mutex);
  EXPECT_EQ(last.evaluations, result.evaluations);
  EXPECT_EQ(last.best.size(), 2U);
  EXPECT_GT(last.hypervolume, 0.0);
}

TEST_F(Optimiser, TakesAFileAndSettingsOfTheGoal) {
  writeFile(folder_.file("study.yaml"), kFront);
  OptimiseGoal asked = goal(folder_.file("study.yaml"));
  asked.settings = {settingMessage("nsga2.generations", "0")};
  const OptimiseResult result = ask(asked);
  ASSERT_EQ(result.status.code, Status::OK + 0) << result.status.message;
  EXPECT_EQ(result.evaluations, 8U);
}

TEST_F(Optimiser, RefusesWhatItCannotRun) {
  EXPECT_EQ(ask(goal(folder_.file("none.yaml"))).status.code, Status::FILE_ERROR + 0);
  const OptimiseResult unknown = ask(goal("name: x\nvariable: {}\n"));
  EXPECT_EQ(unknown.status.code, Status::INVALID_CONFIG + 0);
  EXPECT_NE(unknown.status.message.find("study:1: unknown key 'variable'"), std::string::npos)
      << unknown.status.message;
  OptimiseGoal misspelt = goal(kFront);
  misspelt.settings = {settingMessage("nsga2.popluation", "8")};
  EXPECT_EQ(ask(misspelt).status.code, Status::INVALID_CONFIG + 0);
  EXPECT_FALSE(std::filesystem::exists(misspelt.output));
}

TEST_F(Optimiser, GoesOnWithAJournalUnlessAskedToBeginAnew) {
  OptimiseGoal counted = goal(kFront);
  counted.settings = {settingMessage("nsga2.generations", "0")};
  counted.study.replace(counted.study.find("awk"), 3,
                        "sh, -c, 'echo run >> " + folder_.file("runs") + "; exec awk \"$@\"', sh");
  const auto runs = [&] {
    const std::string text = readFile(folder_.file("runs"));
    return std::count(text.begin(), text.end(), '\n');
  };
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(ask(counted).status.code, Status::OK + 0);
    EXPECT_EQ(runs(), 8) << "the second time all stands in the journal";
  }
  counted.is_fresh = 1;
  EXPECT_EQ(ask(counted).status.code, Status::OK + 0);
  EXPECT_EQ(runs(), 16);
}

TEST_F(Optimiser, StopsWhenCancelledAndGoesOnWhenAskedAgain) {
  OptimiseGoal slow = goal(kFront);
  slow.study.replace(slow.study.find("awk"), 3, "sh, -c, 'sleep 0.2; exec awk \"$@\"', sh");
  std::atomic<bool> has_journal{false};
  client_.sendGoal(slow);
  ASSERT_TRUE(test::waitUntil([&] {
    const std::string journal = slow.output + "/journal.jsonl";
    has_journal =
        std::filesystem::exists(journal) && readFile(journal).find("responses\":[") != std::string::npos;
    return has_journal.load();
  }));
  client_.cancelGoal();
  ASSERT_TRUE(client_.waitForResult(kSearchPatience));
  EXPECT_EQ(client_.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
  EXPECT_EQ(client_.getResult()->status.code, Status::CANCELLED + 0);
  EXPECT_FALSE(std::filesystem::exists(slow.output + "/report.html"));
  const OptimiseResult result = ask(slow);
  EXPECT_EQ(result.status.code, Status::OK + 0) << result.status.message;
  EXPECT_TRUE(std::filesystem::exists(result.report));
}

}  // namespace
}  // namespace lamina
