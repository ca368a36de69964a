// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/resume_steps.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

ResumeConditions robotAtRest() {
  ResumeConditions found;
  found.is_executor_there = true;
  found.executor = "trajectory_driver";
  found.is_by_place = true;
  found.place = "it begins after 15 mm";
  return found;
}

std::string statesOf(const ResumeConditions& found) {
  std::string text;
  for (const ResumeStep& step : resumeSteps(found))
    text += step.name + ' ' + std::to_string(static_cast<int>(step.state)) + ' ';
  return text;
}

TEST(ResumeSteps, AskAPersonForWhatNoMachineProves) {
  EXPECT_EQ(statesOf(robotAtRest()), "link 1 place 2 part 2 ready 2 way 2 ");
  EXPECT_EQ(resumeSteps(robotAtRest())[1].text, "it begins after 15 mm");
}

TEST(ResumeSteps, WaitForWhatIsNotThere) {
  ResumeConditions found = robotAtRest();
  found.is_executor_there = false;
  found.unready = {"bed is cold", "home is open"};
  EXPECT_EQ(statesOf(found), "link 0 place 2 part 2 ready 0 way 2 ");
  EXPECT_EQ(resumeSteps(found)[3].text, "bed is cold; home is open");
  found.refusals = {"the part was taken away"};
  EXPECT_EQ(statesOf(found), "link 0 place 0 part 2 ready 0 way 2 ");
  EXPECT_EQ(resumeSteps(found)[1].text, "the part was taken away");
  found.refusals.clear();
  found.place.clear();
  EXPECT_EQ(resumeSteps(found)[1].state, ResumeStepState::Waits) << "nobody has said yet";
}

TEST(ResumeSteps, TakeACounterOfLinesForAProof) {
  ResumeConditions found = robotAtRest();
  found.is_by_place = false;
  EXPECT_EQ(statesOf(found), "link 1 place 1 part 2 ready 2 way 2 ");
}

TEST(ResumeSteps, AreConfirmedOneByOne) {
  ResumeConditions found = robotAtRest();
  const auto left = [&found](const std::vector<std::string>& confirmed) {
    return unconfirmed(resumeSteps(found), {confirmed}).size();
  };
  EXPECT_EQ(left({}), 4U);
  EXPECT_EQ(left({"way", "place"}), 2U);
  EXPECT_EQ(left({"place", "part", "ready", "way"}), 0U);
  EXPECT_EQ(unconfirmed(resumeSteps(found), {{"part", "ready", "way"}}),
            std::vector<std::string>{"a person has to confirm 'place': it begins after 15 mm"});
  found.unready = {"bed is cold"};
  EXPECT_EQ(left({"place", "part", "way"}), 0U) << "what waits is for others to refuse";
}

/// Somebody has moved the robot between the look and the command.
TEST(ResumeSteps, AreNotConfirmedWhereThePlaceHasBecomeAnotherOne) {
  ResumeConditions found = robotAtRest();
  found.begin_mm = 15.0;
  const std::vector<std::string> all = {"place", "part", "ready", "way"};
  const auto against = [&](std::optional<double> begin_mm) {
    return unconfirmed(resumeSteps(found), {all, begin_mm});
  };
  EXPECT_EQ(resumeSteps(found)[1].begin_mm, 15.0);
  EXPECT_FALSE(resumeSteps(found)[2].begin_mm);
  EXPECT_TRUE(against({}).empty()) << "who states no place means the one that is shown";
  EXPECT_TRUE(against(15.4).empty());
  EXPECT_EQ(against(12.25), std::vector<std::string>{
                                "the 'place' that was confirmed begins after 12.25 mm of beads, the job now "
                                "after 15 mm; expected the same to 0.5 mm: look at it, and confirm it anew"});
  EXPECT_EQ(against(15.6).size(), 1U);
  found.begin_mm.reset();
  found.place = "it begins anew";
  EXPECT_EQ(against(12.25),
            std::vector<std::string>{
                "the 'place' that was confirmed begins after 12.25 mm of beads, and the job now "
                "elsewhere: it begins anew; look at it, and confirm it anew"});
  EXPECT_TRUE(against({}).empty());
  found.is_by_place = false;
  EXPECT_TRUE(against(12.25).empty()) << "a counter of lines proves its place";
}

TEST(ResumeSteps, ShowTheTemperatures) {
  ResumeConditions found = robotAtRest();
  found.temperatures = "nozzle 41 °C";
  EXPECT_NE(resumeSteps(found)[3].text.find("; last reported: nozzle 41 °C"), std::string::npos);
}

}  // namespace
}  // namespace lamina
