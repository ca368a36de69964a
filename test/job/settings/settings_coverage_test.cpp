// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Every setting has a row that says what changes with it, and it changes.
#include <gtest/gtest.h>

#include <set>

#include "job/settings/covered_schemas.hpp"
#include "job/settings/setting_probe.hpp"
#include "lamina/base/atomic_file.hpp"

namespace lamina::test {
namespace {

std::vector<SettingProbe> allProbes() {
  std::vector<SettingProbe> all;
  for (const auto& probes :
       {sliceProbes(),      layerProbes(),   fillProbes(),     flowProbes(),     runProbes(),
        dropProbes(),       programProbes(), jointProbes(),    motionProbes(),   measureProbes(),
        platformProbes(),   inclineProbes(), searchProbes(),   scaffoldProbes(), streamProbes(),
        emulatorProbes(),   startupProbes(), approachProbes(), monitorProbes(),  bridgeProbes(),
        skinProbes(),       supportProbes(), heightProbes(),   arcProbes(),      hookProbes(),
        plateProbes(),      toolProbes(),    profileProbes(),  loopProbes(),     resumeProbes(),
        calibrationProbes()})
    all.insert(all.end(), probes.begin(), probes.end());
  return all;
}

TEST(SettingsCoverage, EverySettingHasARow) {
  std::set<std::string> covered;
  for (const SettingProbe& probe : allProbes())
    for (const SettingRow& row : probe.rows) covered.insert(changedKey(row));
  for (const TestedElsewhere& setting : testedElsewhere()) covered.insert(setting.key);
  for (const std::string& key : coreKeys())
    EXPECT_TRUE(covered.erase(key) > 0) << key << " changes nothing that a row expects";
  for (const std::string& key : covered) ADD_FAILURE() << key << " is no setting";
}

TEST(SettingsCoverage, WhatOtherTestsCoverStandsInThem) {
  for (const TestedElsewhere& setting : testedElsewhere()) {
    const std::string text = readFile(std::string(LAMINA_SOURCE_DIR) + "/test/" + setting.file);
    EXPECT_NE(text.find(setting.word), std::string::npos) << setting.key << " in " << setting.file;
  }
}

TEST(SettingsCoverage, OfSlicing) { expectEffects(sliceProbes()); }
TEST(SettingsCoverage, OfSupports) { expectEffects(supportProbes()); }
TEST(SettingsCoverage, OfLayers) { expectEffects(layerProbes()); }
TEST(SettingsCoverage, OfFills) { expectEffects(fillProbes()); }
TEST(SettingsCoverage, OfDrops) { expectEffects(dropProbes()); }
TEST(SettingsCoverage, OfProfiles) { expectEffects(profileProbes()); }
TEST(SettingsCoverage, OfPrograms) { expectEffects(programProbes()); }
TEST(SettingsCoverage, OfJoints) { expectEffects(jointProbes()); }
TEST(SettingsCoverage, OfMotion) { expectEffects(motionProbes()); }
TEST(SettingsCoverage, OfMeasures) { expectEffects(measureProbes()); }
TEST(SettingsCoverage, OfThePlatform) { expectEffects(platformProbes()); }
TEST(SettingsCoverage, OfInclining) { expectEffects(inclineProbes()); }
TEST(SettingsCoverage, OfSearches) { expectEffects(searchProbes()); }
TEST(SettingsCoverage, OfScaffolds) { expectEffects(scaffoldProbes()); }
TEST(SettingsCoverage, OfStreaming) { expectEffects(streamProbes()); }
TEST(SettingsCoverage, OfTheEmulator) { expectEffects(emulatorProbes()); }
TEST(SettingsCoverage, OfStartup) { expectEffects(startupProbes()); }
TEST(SettingsCoverage, OfApproaches) { expectEffects(approachProbes()); }
TEST(SettingsCoverage, OfPlates) { expectEffects(plateProbes()); }
TEST(SettingsCoverage, OfMonitoring) { expectEffects(monitorProbes()); }
TEST(SettingsCoverage, OfBridges) { expectEffects(bridgeProbes()); }
TEST(SettingsCoverage, OfSkins) { expectEffects(skinProbes()); }
TEST(SettingsCoverage, OfHeights) { expectEffects(heightProbes()); }
TEST(SettingsCoverage, OfRuns) { expectEffects(runProbes()); }
TEST(SettingsCoverage, OfFlow) { expectEffects(flowProbes()); }
TEST(SettingsCoverage, OfArcs) { expectEffects(arcProbes()); }
TEST(SettingsCoverage, OfHooks) { expectEffects(hookProbes()); }
TEST(SettingsCoverage, OfClosedLoops) { expectEffects(loopProbes()); }
TEST(SettingsCoverage, OfTools) { expectEffects(toolProbes()); }
TEST(SettingsCoverage, OfResuming) { expectEffects(resumeProbes()); }
TEST(SettingsCoverage, OfCalibration) { expectEffects(calibrationProbes()); }

}  // namespace
}  // namespace lamina::test
