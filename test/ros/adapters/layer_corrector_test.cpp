// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/gcode_streamer/layer_corrector.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/fading_map.hpp"
#include "lamina/control/feeder_lead.hpp"
#include "lamina/control/program/planned_correction.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "nodes/gcode_streamer/corrected_stream.hpp"
#include "support/control_layers.hpp"
#include "support/corrected_programs.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// Two beads each in three layers.
Toolpath beads() { return test::stackedBeads(3); }

Eigen::Isometry3d onBed() { return Eigen::Isometry3d(Eigen::Translation3d(50.0, 60.0, 0.0)); }

std::string textOf(const Toolpath& part) {
  std::string text;
  writeGcode(part, onBed(), {}, [&](std::string_view piece) { text += piece; });
  return text;
}

StreamableProgram beadProgram() { return StreamableProgram::fromText("beads", textOf(beads())); }

ProgrammedToolpath programmed() { return {toolpathId(beads()), placed(beads(), onBed())}; }

/// The amount along all beads of a layer.
CorrectionMap constantMap(std::size_t layer, double amount, std::uint64_t sequence = 1) {
  const Toolpath part = beads();
  const LayerCells cells = layerCells(part.layers[layer], layer, 0.5);
  return correctionMap(cells, {std::vector<double>(cells.size(), amount), {}, {}}, toolpathId(part),
                       sequence);
}

/// The program as the corrector gives it on, each layer decided when it comes.
std::string sent(LayerCorrector& corrector) {
  std::istringstream text(textOf(beads()));
  std::string out;
  std::string line;
  std::int32_t layer = -1;
  for (std::uint64_t number = 1; std::getline(text, line); ++number) {
    if (line.compare(0, 7, ";LAYER:") == 0) corrector.decide(++layer);
    out += corrector.revised(line, number) + "\n";
  }
  return out;
}

StreamCorrectionSettings used() {
  StreamCorrectionSettings settings;
  settings.is_used = true;
  return settings;
}

TEST(LayerCorrector, WithoutMapsOrWithMapsOfNothingSendsTheProgram) {
  LayerCorrector silent(beadProgram(), programmed(), used());
  EXPECT_EQ(sent(silent), textOf(beads()));
  LayerCorrector idle(beadProgram(), programmed(), used());
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(idle.hear(constantMap(k, 0.0)), "");
  EXPECT_EQ(sent(idle), textOf(beads()));
}

TEST(LayerCorrector, AppliesTheLatestMapOfEachLayer) {
  LayerCorrector corrector(beadProgram(), programmed(), used());
  EXPECT_TRUE(corrector.isKnown(0)) << "nothing can be known of the first layer";
  EXPECT_FALSE(corrector.isKnown(1));
  EXPECT_EQ(corrector.hear(constantMap(1, 0.3)), "");
  const CorrectionMap latest = constantMap(1, 0.1, 2);
  EXPECT_EQ(corrector.hear(latest), "");
  EXPECT_TRUE(corrector.isKnown(1));
  EXPECT_NE(corrector.hear(constantMap(1, 0.5, 2)).find("on its way"), std::string::npos) << "no later one";
  EXPECT_NE(corrector.hear(constantMap(0, 0.5, 3)).find("on its way"), std::string::npos);
  CorrectionMap expected = latest;
  expected.toolpath_id = toolpathId(programmed().toolpath);
  CorrectionMap fading = fadingMap(programmed().toolpath.layers[2], 2, 0.1, 0.5, LoopSettings());
  fading.toolpath_id = expected.toolpath_id;
  EXPECT_EQ(sent(corrector),
            correctedProgram(textOf(beads()), programmed().toolpath, {expected, fading}, {}).text);
  const std::vector<LayerDecision> decisions = corrector.decisions();
  ASSERT_EQ(decisions.size(), 3U);
  EXPECT_EQ(decisions[0].digest, "");
  EXPECT_EQ(decisions[1].digest, digestOf(latest));
  EXPECT_EQ(decisions[1].sequence, 2U);
  EXPECT_EQ(decisions[2].digest, "");
}

/// The map of the third layer does not come: the 0.1 that the second ended with fade at 0.05 per mm, at
/// stations 0.5 mm apart, as what the feeder follows at 10 mm/s.
TEST(LayerCorrector, FadesFromLayerToLayerWhereNoMapComes) {
  const test::ScratchFolder folder;
  StreamCorrectionSettings settings = used();
  settings.folder = folder.file("record");
  LayerCorrector corrector(beadProgram(), programmed(), settings);
  EXPECT_EQ(corrector.hear(constantMap(1, 0.1)), "");
  const std::string deposited = sent(corrector);
  EXPECT_EQ(corrector.decisions()[2].digest, "") << "reported as missed";
  const CorrectionMap fading = readCorrectionMap(readFile(settings.folder + "/layer_2.csv"), "layer_2.csv");
  ASSERT_EQ(fading.paths.size(), 1U) << "the second bead is as planned";
  const auto& stations = fading.paths[0].stations;
  EXPECT_NEAR(stations[0].amount, 0.075, 1e-12);
  EXPECT_NEAR(stations[1].amount, 0.05, 1e-12);
  EXPECT_NEAR(stations[2].amount, 0.025, 1e-12);
  for (std::size_t i = 3; i < stations.size(); ++i) EXPECT_NEAR(stations[i].amount, 0.0, 1e-12) << i;
  const CorrectionReport one =
      correctedByMaps("beads", textOf(beads()), {programmed(), {{"", constantMap(1, 0.1)}}, {}}).report;
  // Two beads of 40 mm are one layer: 0.075 mm of its length more.
  const double layer_mm = one.planned_mm;
  EXPECT_NEAR(test::filamentOf(deposited) - test::filamentOf(textOf(beads())),
              0.1 * layer_mm + 0.075 * layer_mm / 80.0, 1e-3 * layer_mm / 80.0 + 1e-4);
  const PlannedCorrection again = test::recordedIn(settings.folder, settings.loop);
  EXPECT_EQ(correctedByMaps("beads", textOf(beads()), again).text, deposited) << "made again from the record";
}

TEST(LayerCorrector, LeadsTheFeeder) {
  StreamCorrectionSettings settings = used();
  settings.loop.dead_time_s = 1.0;
  LayerCorrector corrector(beadProgram(), programmed(), settings);
  const Toolpath part = beads();
  const LayerCells cells = layerCells(part.layers[1], 1, 0.5);
  CellCorrections ramp;
  for (const double along : cells.along_mm) ramp.amount.push_back(0.005 * along);
  const CorrectionMap map = correctionMap(cells, ramp, toolpathId(part), 1);
  EXPECT_EQ(corrector.hear(map), "");
  CorrectionMap led = ledMap(map, part.layers[1], {1.0, 0.0}, settings.loop);
  EXPECT_NEAR(correctionAt(led.paths[0], 20.0).amount, 0.15, 1e-9) << "10 mm ahead at 10 mm/s";
  led.toolpath_id = toolpathId(programmed().toolpath);
  EXPECT_EQ(sent(corrector), correctedProgram(textOf(part), programmed().toolpath, {led}, {}).text);
}

TEST(LayerCorrector, RefusesWhatIsNotForTheProgram) {
  LayerCorrector corrector(beadProgram(), programmed(), used());
  CorrectionMap other = constantMap(1, 0.1);
  other.toolpath_id = "other";
  EXPECT_NE(corrector.hear(other).find("of toolpath other"), std::string::npos);
  CorrectionMap beyond = constantMap(1, 0.1);
  beyond.layer = 3;
  EXPECT_NE(corrector.hear(beyond).find("the toolpath has 3"), std::string::npos);
  CorrectionMap high = constantMap(1, 0.1);
  high.paths[0].stations[4].dz_mm = -1.6;
  EXPECT_NE(corrector.hear(high).find("moves the nozzle by -1.6"), std::string::npos);
  const auto elsewhere = StreamableProgram::fromText("elsewhere", "G28\n;LAYER:0\nG1 X1 Y1 Z1 E1 F600\n");
  EXPECT_THROW(LayerCorrector(elsewhere, programmed(), used()), InvalidProgram);
}

TEST(LayerCorrector, RecordsWhatWasAppliedSoThatItCanBeDepositedAgain) {
  const test::ScratchFolder folder;
  StreamCorrectionSettings settings = used();
  settings.folder = folder.file("record");
  LayerCorrector corrector(beadProgram(), programmed(), settings);
  const CorrectionMap map = constantMap(2, 0.2);
  EXPECT_EQ(corrector.hear(map), "");
  const std::string deposited = sent(corrector);
  EXPECT_EQ(corrector.recordFailure(), "");
  const std::string record = readFile(settings.folder + "/record.csv");
  EXPECT_NE(record.find("# toolpath " + toolpathId(beads())), std::string::npos) << record;
  EXPECT_NE(record.find("layer,sequence,digest,from_line\n0,0,none,"), std::string::npos) << record;
  EXPECT_NE(record.find("\n1,0,none,"), std::string::npos) << record;
  EXPECT_NE(record.find("\n2,1," + digestOf(map) + ","), std::string::npos) << record;
  const std::string kept = readFile(settings.folder + "/layer_2.csv");
  EXPECT_EQ(digestOf(readCorrectionMap(kept, "layer_2.csv")), digestOf(map));
  const PlannedCorrection again = test::recordedIn(settings.folder, settings.loop);
  EXPECT_EQ(correctedByMaps("beads", textOf(beads()), again).text, deposited) << "made again from the record";
}

/// What cannot begin leaves what is known of the job before.
TEST(LayerCorrector, TakesThePlaceOfARecordWithItsFirstLine) {
  const test::ScratchFolder folder;
  StreamCorrectionSettings settings = used();
  settings.folder = folder.file("record");
  LayerCorrector before(beadProgram(), programmed(), settings);
  EXPECT_EQ(before.hear(constantMap(1, 0.2)), "");
  sent(before);
  const std::string known = readFile(settings.folder + "/record.csv");
  LayerCorrector next(beadProgram(), programmed(), settings);
  EXPECT_EQ(readFile(settings.folder + "/record.csv"), known);
  EXPECT_EQ(next.revised("; begins", 1), "; begins");
  const std::string begun = readFile(settings.folder + "/record.csv");
  EXPECT_EQ(begun.find("\n1,1,"), std::string::npos) << begun;
  EXPECT_NE(recordedJob(settings.folder)->job, "");
  EXPECT_EQ(recordedJob(settings.folder)->job, next.record()->job);
}

TEST(LayerCorrector, RefusesAFolderThatIsNone) {
  const test::ScratchFolder folder;
  writeFile(folder.file("record"), "a file");
  StreamCorrectionSettings settings = used();
  settings.folder = folder.file("record");
  EXPECT_THROW(LayerCorrector(beadProgram(), programmed(), settings), FileError);
}

/// A record that fails is reported in each job.
TEST(LayerCorrector, ReportsARecordThatFailsOnceAJob) {
  for (int job = 0; job < 2; ++job) {
    const test::ScratchFolder folder;
    StreamCorrectionSettings settings = used();
    settings.folder = folder.file("record");
    CorrectedStream stream(std::make_shared<LayerCorrector>(beadProgram(), programmed(), settings));
    EXPECT_EQ(stream.takeRecordFailure(), "");
    EXPECT_EQ(stream.revised("; begins", 1), "; begins");
    std::filesystem::remove_all(settings.folder);
    EXPECT_TRUE(stream.isKnown(0));
    EXPECT_NE(stream.takeRecordFailure().find("record.csv"), std::string::npos);
    EXPECT_EQ(stream.takeRecordFailure(), "");
    EXPECT_NE(stream.recordFailure(), "");
  }
}

/// In the layer that is under way, the first of its two beads is deposited by the map that it began with.
TEST(LayerCorrector, TrimsALayerThatIsUnderWay) {
  const test::ScratchFolder folder;
  StreamCorrectionSettings settings = used();
  settings.folder = folder.file("record");
  LayerCorrector corrector(beadProgram(), programmed(), settings);
  EXPECT_EQ(corrector.hear(constantMap(1, 0.3)), "");
  std::istringstream text(textOf(beads()));
  std::string deposited, line;
  std::int32_t layer = -1;
  int deposits = 0;
  for (std::uint64_t number = 1; std::getline(text, line); ++number) {
    if (line.compare(0, 7, ";LAYER:") == 0) corrector.decide(++layer);
    deposited += corrector.revised(line, number) + "\n";
    deposits += line.find(" E") != std::string::npos && line.find("G1 X") != std::string::npos ? 1 : 0;
    if (deposits != 3 || layer != 1 || corrector.decisions().back().sequence != 1) continue;
    EXPECT_EQ(corrector.hear(constantMap(1, 0.1, 2)), "");
    EXPECT_EQ(corrector.hear(constantMap(1, -0.1, 3)), "") << "before the next line";
  }
  EXPECT_NE(corrector.hear(constantMap(2, 0.2, 9)).find("on its way"), std::string::npos)
      << "it was reported to be deposited as planned";
  EXPECT_EQ(deposits, 6);
  EXPECT_EQ(corrector.recordFailure(), "");
  const std::vector<LayerDecision> decisions = corrector.decisions();
  ASSERT_EQ(decisions.size(), 4U);
  EXPECT_EQ(decisions[2].layer, 1U);
  EXPECT_EQ(decisions[2].sequence, 3U);
  EXPECT_GT(decisions[2].from_line, 0U);
  const CorrectionReport report =
      correctedByMaps("beads", textOf(beads()), {programmed(), {{"", constantMap(1, 0.1)}}, {}}).report;
  const double bead_mm = 0.5 * report.planned_mm;
  // The third layer begins with -0.1, which fade as 0.075 mm of a bead of 40 mm.
  EXPECT_NEAR(test::filamentOf(deposited) - test::filamentOf(textOf(beads())),
              (0.3 - 0.1 - 0.075 / 40.0) * bead_mm, 1e-4);
  const PlannedCorrection again = test::recordedIn(settings.folder, settings.loop);
  EXPECT_EQ(again.maps.size(), 3U);
  EXPECT_EQ(correctedByMaps("beads", textOf(beads()), again).text, deposited) << "made again from the record";
}

TEST(LayerCorrector, GoesOverToAPlanWhereItWaits) {
  const auto first = std::make_shared<LayerCorrector>(beadProgram(), programmed(), used());
  CorrectedStream stream(first);
  const std::string id = replannedId(beads(), 1, toolpathId(beads()));
  std::size_t from = 0;
  const auto write = [&](const LayerCorrector&, std::size_t layer) {
    from = layer;
    EXPECT_FALSE(stream.isKnown(1));
    stream.decide(1);
    EXPECT_FALSE(stream.isKnown(1)) << "it waits while the plan is written";
    return PlannedProgram{beadProgram(), std::make_shared<LayerCorrector>(
                                             beadProgram(), ProgrammedToolpath{id, programmed().toolpath},
                                             used(), FirstMap::Awaited)};
  };
  EXPECT_TRUE(stream.isKnown(0));
  EXPECT_NE(stream.goOverTo(id, write).find("held in front of none"), std::string::npos);
  EXPECT_FALSE(stream.isKnown(1));
  EXPECT_NE(stream.goOverTo("other", write).find("no plan of toolpath"), std::string::npos);
  EXPECT_FALSE(stream.successor(1));
  EXPECT_THROW(stream.goOverTo(id, [](const auto&, auto) -> PlannedProgram { throw InvalidInput("no"); }),
               InvalidInput);
  stream.decide(1);
  EXPECT_FALSE(stream.isKnown(1)) << "until the plan is dropped";
  stream.dropPlan();
  EXPECT_FALSE(stream.isFollowing(id));
  EXPECT_EQ(stream.goOverTo(id, write), "");
  EXPECT_TRUE(stream.isFollowing(id));
  EXPECT_EQ(from, 1U);
  EXPECT_NE(stream.goOverTo(id, write).find("goes over to another plan"), std::string::npos)
      << "it came twice";
  CorrectionMap of_plan = constantMap(0, 0.2);
  of_plan.toolpath_id = id;
  EXPECT_FALSE(stream.isKnown(1)) << "the layer planned first is not begun any more";
  ASSERT_TRUE(stream.successor(1));
  EXPECT_FALSE(stream.isKnown(0)) << "the first layer of a plan waits, too";
  EXPECT_EQ(stream.hear(of_plan), "");
  EXPECT_TRUE(stream.isKnown(0));
  const std::vector<StreamDecision> reported = stream.takeDecisions();
  ASSERT_EQ(reported.size(), 2U);
  EXPECT_EQ(reported[0].toolpath_id, toolpathId(beads()));
  EXPECT_EQ(reported[1].toolpath_id, id);
  EXPECT_EQ(reported[1].decision.digest, digestOf(of_plan));
}

TEST(LayerCorrector, AProgramThatGoesOnPushesForthWhatWasPulledBack) {
  Toolpath part = beads();
  EXPECT_EQ(settingsToGoOn({}, part, 1).start_code, "");
  part.layers[1].paths.front().process.is_retracted = true;
  EXPECT_EQ(settingsToGoOn({}, part, 1).start_code, "") << "pulled back behind the beginning of the layer";
  Path scan = part.layers[1].paths.front();
  part.layers[0].paths.push_back(scan);
  EXPECT_EQ(settingsToGoOn({}, part, 1).start_code, "M83\nG1 E0.80000 F2100.000");
  part.layers[0].paths[0].tool = 1;
  EXPECT_THROW(settingsToGoOn({}, part, 1), InvalidInput);
}

/// The second layer ends with 0.3 more; of the third nothing but its coasting map of 0.1 comes, and its own
/// one when it is on its way.
TEST(LayerCorrector, TakesTheCoastingMapOfALayerThatIsWaitedForInVain) {
  const test::ScratchFolder folder;
  StreamCorrectionSettings settings = used();
  settings.folder = folder.file("record");
  LayerCorrector corrector(beadProgram(), programmed(), settings);
  const CorrectionMap coasting = constantMap(2, 0.1, 0);
  EXPECT_EQ(corrector.hear(constantMap(1, 0.3)), "");
  EXPECT_EQ(corrector.hear(constantMap(1, 0.2, 0)), "") << "not needed, as its own is there";
  EXPECT_EQ(corrector.hear(coasting), "");
  EXPECT_FALSE(corrector.isKnown(2)) << "its own is waited for";
  const std::string deposited = sent(corrector);
  EXPECT_NE(corrector.hear(constantMap(2, 0.2)), "") << "the loop learns from the coasting map";
  const std::vector<LayerDecision> decisions = corrector.decisions();
  ASSERT_EQ(decisions.size(), 3U);
  EXPECT_EQ(decisions[1].digest, digestOf(constantMap(1, 0.3)));
  EXPECT_EQ(decisions[2].digest, digestOf(coasting));
  EXPECT_TRUE(decisions[2].is_coasting);
  EXPECT_EQ(decisions[2].waited_s, settings.loop.wait_s);
  const CorrectionMap kept = readCorrectionMap(readFile(settings.folder + "/layer_2.csv"), "layer_2.csv");
  EXPECT_NEAR(kept.paths[0].stations[0].amount, 0.275, 1e-12) << "0.5 /s at 10 mm/s, 0.5 mm on";
  EXPECT_EQ(kept.paths[0].stations[20].amount, 0.1);
  const PlannedCorrection again = test::recordedIn(settings.folder, settings.loop);
  EXPECT_EQ(correctedByMaps("beads", textOf(beads()), again).text, deposited) << "made again from the record";
}

TEST(LayerCorrector, ReadsItsSettings) {
  StreamCorrectionSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  EXPECT_FALSE(settings.is_used);
  schema.set("corrections.use", "true");
  schema.set("corrections.folder", "here");
  schema.set("loop.wait_s", "5");
  EXPECT_TRUE(settings.is_used);
  EXPECT_EQ(settings.folder, "here");
  EXPECT_EQ(LayerCorrector(beadProgram(), programmed(), {true, "", settings.loop, "", false}).waitTime(),
            5.0);
}

}  // namespace
}  // namespace lamina
