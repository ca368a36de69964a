// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/mode_choice.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

ModeCandidate candidate(const std::string& mode, double unsupported_percent, std::size_t steps,
                        double time_s) {
  ModeCandidate made;
  made.mode = mode;
  made.unsupported_percent = unsupported_percent;
  made.steps = steps;
  made.layers = 10 * steps;
  made.time_s = time_s;
  return made;
}

ModeCandidate refused(const std::string& mode) {
  ModeCandidate made;
  made.mode = mode;
  made.refusal = "the mesh is open";
  return made;
}

std::string chosenName(const std::vector<ModeCandidate>& candidates, const AutomaticSettings& settings = {}) {
  const auto place = chosenMode(candidates, settings);
  return place ? candidates[*place].mode : "none";
}

TEST(ModeChoice, TheFirstThatIsGoodEnoughIsTaken) {
  EXPECT_EQ(chosenName({candidate("planar", 0.0, 1, 60.0), candidate("volumetric", 0.0, 40, 30.0)}),
            "planar");
  EXPECT_EQ(chosenName({candidate("planar", 1.0, 1, 60.0), candidate("volumetric", 0.0, 40, 30.0)}),
            "planar");
  EXPECT_EQ(chosenName({candidate("planar", 1.01, 1, 60.0), candidate("multi_direction", 0.9, 3, 70.0),
                        candidate("volumetric", 0.0, 40, 65.0)}),
            "multi_direction");
}

TEST(ModeChoice, WhatIsGoodEnoughIsASetting) {
  const std::vector<ModeCandidate> both = {candidate("planar", 6.0, 1, 60.0),
                                           candidate("volumetric", 2.0, 40, 60.0)};
  AutomaticSettings settings;
  EXPECT_EQ(chosenName(both, settings), "volumetric");
  settings.good_unsupported_percent = 6.0;
  EXPECT_EQ(chosenName(both, settings), "planar");
}

TEST(ModeChoice, WhereNoneIsGoodEnoughTheFewestStepsOfTheBestAreTaken) {
  AutomaticSettings settings;
  settings.alike_percent = 0.5;
  // 4.4 and 4.0 are alike, 4.6 is worse.
  EXPECT_EQ(chosenName({candidate("planar", 4.6, 1, 60.0), candidate("multi_direction", 4.4, 3, 60.0),
                        candidate("volumetric", 4.0, 40, 60.0)},
                       settings),
            "multi_direction");
  settings.alike_percent = 0.7;
  EXPECT_EQ(chosenName({candidate("planar", 4.6, 1, 60.0), candidate("volumetric", 4.0, 40, 60.0)}, settings),
            "planar");
  settings.alike_percent = 0.0;
  EXPECT_EQ(chosenName({candidate("planar", 4.6, 1, 60.0), candidate("volumetric", 4.0, 40, 60.0)}, settings),
            "volumetric");
}

TEST(ModeChoice, OfAsManyStepsTheQuickestThenTheFirst) {
  EXPECT_EQ(chosenName({candidate("adapted", 4.0, 40, 61.0), candidate("volumetric", 4.2, 40, 60.0)}),
            "volumetric");
  EXPECT_EQ(chosenName({candidate("adapted", 4.2, 40, 60.0), candidate("volumetric", 4.0, 40, 60.0)}),
            "adapted");
}

TEST(ModeChoice, WhatTakesTooLongIsPassedOver) {
  const std::vector<ModeCandidate> both = {candidate("planar", 20.0, 1, 100.0),
                                           candidate("volumetric", 0.0, 40, 301.0)};
  AutomaticSettings settings;
  EXPECT_EQ(chosenName(both, settings), "planar");
  settings.longest_time = 3.02;
  EXPECT_EQ(chosenName(both, settings), "volumetric");
}

TEST(ModeChoice, RefusedOnesCountForNothing) {
  // The time 0 of the refused one makes no other too long.
  EXPECT_EQ(chosenName({refused("planar"), candidate("volumetric", 20.0, 40, 100.0)}), "volumetric");
  EXPECT_EQ(chosenName({refused("planar"), refused("volumetric")}), "none");
  EXPECT_EQ(chosenName({}), "none");
}

TEST(ModeChoice, NoFurtherOneIsTriedBehindAGoodOne) {
  const AutomaticSettings settings;
  EXPECT_TRUE(isLastGoodEnough({candidate("planar", 0.9, 1, 100.0)}, settings));
  EXPECT_FALSE(isLastGoodEnough({candidate("planar", 1.1, 1, 100.0)}, settings));
  EXPECT_FALSE(isLastGoodEnough({candidate("planar", 9.0, 1, 100.0), refused("adapted")}, settings));
  EXPECT_FALSE(isLastGoodEnough({candidate("planar", 9.0, 1, 100.0), candidate("volumetric", 0.0, 9, 301.0)},
                                settings))
      << "it takes too long";
  EXPECT_FALSE(isLastGoodEnough({}, settings));
}

// What comes later is not tried, and so makes nothing too slow that is good enough.
TEST(ModeChoice, AGoodOneIsNotRuledOutByALaterOneThatIsQuicker) {
  EXPECT_EQ(chosenName({candidate("planar", 0.0, 1, 100.0), candidate("volumetric", 0.0, 40, 30.0)}),
            "planar");
  EXPECT_EQ(chosenName({candidate("planar", 1.5, 1, 100.0), candidate("multi_direction", 0.5, 3, 120.0),
                        candidate("volumetric", 0.0, 40, 30.0)}),
            "multi_direction");
  // What is not good enough is.
  EXPECT_EQ(chosenName({candidate("planar", 1.5, 1, 100.0), candidate("volumetric", 1.5, 40, 30.0)}),
            "volumetric");
}

// Whoever tries modes one after the other takes what the whole table gives.
TEST(ModeChoice, StoppingEarlyChangesNothing) {
  const AutomaticSettings settings;
  const double shares[] = {0.0, 1.0, 1.3, 4.0};
  const double times[] = {30.0, 50.0, 100.0, 160.0};
  for (const double a : shares)
    for (const double b : shares)
      for (const double time : times) {
        const std::vector<ModeCandidate> all = {candidate("planar", a, 1, 100.0),
                                                candidate("multi_direction", b, 3, time),
                                                candidate("volumetric", 0.0, 40, 25.0)};
        std::vector<ModeCandidate> tried;
        for (const ModeCandidate& each : all) {
          tried.push_back(each);
          if (isLastGoodEnough(tried, settings)) break;
        }
        EXPECT_EQ(chosenName(tried), chosenName(all)) << a << " " << b << " " << time;
      }
}

TEST(ModeChoice, OneThatIsNoBetterInAnythingIsOutdone) {
  const ModeCandidate planar = candidate("planar", 4.0, 1, 60.0);
  EXPECT_TRUE(isOutdone({planar, candidate("volumetric", 4.0, 40, 60.0)}, 1));
  EXPECT_FALSE(isOutdone({planar, candidate("volumetric", 4.0, 40, 60.0)}, 0));
  EXPECT_FALSE(isOutdone({planar, candidate("volumetric", 3.9, 40, 60.0)}, 1)) << "it leaves less";
  EXPECT_FALSE(isOutdone({planar, candidate("volumetric", 4.0, 40, 59.0)}, 1)) << "it is quicker";
  EXPECT_FALSE(isOutdone({planar, candidate("volumetric", 3.0, 1, 60.0)}, 0)) << "the first of alike ones";
  EXPECT_TRUE(isOutdone({planar, candidate("volumetric", 3.0, 1, 59.0)}, 0));
  EXPECT_TRUE(isOutdone({refused("adapted")}, 0));
  EXPECT_FALSE(isOutdone({refused("adapted"), planar}, 1)) << "by one that is refused";
}

// Its plan may be thrown away, then, before the rest is tried.
TEST(ModeChoice, AnOutdoneOneIsNeverChosen) {
  std::vector<ModeCandidate> each = {refused("x")};
  for (const double share : {0.0, 1.3, 1.6, 4.0})
    for (const std::size_t steps : {1, 3})
      for (const double time : {30.0, 60.0, 100.0}) each.push_back(candidate("x", share, steps, time));
  std::size_t outdone = 0;
  for (const ModeCandidate& a : each)
    for (const ModeCandidate& b : each)
      for (const ModeCandidate& c : each) {
        if (isLastGoodEnough({a}, {}) || isLastGoodEnough({a, b}, {})) continue;
        const auto chosen = chosenMode({a, b, c}, {});
        if (!chosen) continue;
        if (*chosen < 2) {
          EXPECT_FALSE(isOutdone({a, b}, *chosen));
        }
        EXPECT_FALSE(isOutdone({a, b, c}, *chosen));
        outdone += isOutdone({a, b}, 0) ? 1 : 0;
      }
  EXPECT_GT(outdone, 1000U);
}

TEST(ModeChoice, TheReasonHasTheNumbers) {
  const AutomaticSettings settings;
  const std::vector<ModeCandidate> all = {candidate("planar", 13.95, 1, 2520.0),
                                          candidate("multi_direction", 0.25, 3, 2700.0)};
  EXPECT_EQ(
      reasonFor(all, 1, settings),
      "it leaves 0.25 % of the surface unsupported in 3 steps, 30 layers, 45.0 min, the simplest with at "
      "most 1 %; planar would leave 13.95 % of the surface unsupported in 1 step, 10 layers, 42.0 min");
  EXPECT_EQ(noteOn(all, 0, settings),
            "not planar: it would leave 13.95 % of the surface unsupported in 1 step, 10 layers, 42.0 min");
  EXPECT_EQ(noteOn({refused("adapted")}, 0, settings), "not adapted: the mesh is open");
  const std::vector<ModeCandidate> slow = {candidate("planar", 13.0, 1, 60.0),
                                           candidate("volumetric", 0.0, 40, 600.0)};
  EXPECT_NE(noteOn(slow, 1, settings).find("it may take 3.0 min (auto.longest_time)"), std::string::npos);
}

TEST(ModeChoice, TheReasonNamesWhatTheMachineCannotRun) {
  const AutomaticSettings settings;
  std::vector<ModeCandidate> all = {candidate("planar", 13.95, 1, 2520.0),
                                    candidate("multi_direction", 0.25, 3, 2700.0), refused("adapted")};
  EXPECT_EQ(machineRefusals(all), "") << "adapted refuses the part itself";
  all[1].refusal = "layer 3: out of reach";
  const std::string pieces =
      "would leave 0.25 % of the surface unsupported in 3 steps, 30 layers, 45.0 min, but the machine cannot "
      "run it: layer 3: out of reach";
  EXPECT_EQ(machineRefusals(all), "; multi_direction " + pieces);
  EXPECT_EQ(noteOn(all, 1, settings), "not multi_direction: it " + pieces);
  EXPECT_EQ(chosenName(all), "planar");
  EXPECT_NE(
      reasonFor(all, 0, settings).find("about the least; none that the machine can run leaves at most 1 %"),
      std::string::npos);
}

// Of three minutes and more nothing is said to leave too much.
TEST(ModeChoice, TheReasonSaysWhereTimeDecided) {
  const AutomaticSettings settings;
  const ModeCandidate planar = candidate("planar", 13.0, 1, 60.0);
  EXPECT_EQ(
      reasonFor({planar, candidate("volumetric", 0.0, 40, 600.0)}, 0, settings),
      "it leaves 13.00 % of the surface unsupported in 1 step, 10 layers, 1.0 min, in the fewest steps of "
      "those that leave about the least; none of those that take at most 3.0 min (auto.longest_time) "
      "leaves at most 1 %");
  EXPECT_NE(reasonFor({planar, candidate("volumetric", 13.0, 40, 120.0)}, 0, settings)
                .find("about the least; none leaves at most 1 %"),
            std::string::npos);
  EXPECT_NE(reasonFor({planar, candidate("multi_direction", 0.1, 3, 181.0),
                       candidate("volumetric", 0.2, 40, 179.0)},
                      2, settings)
                .find("the simplest of those that take at most 3.0 min (auto.longest_time) with at most 1 %"),
            std::string::npos);
}

}  // namespace
}  // namespace lamina
