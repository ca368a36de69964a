// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/gcode_streamer/layer_corrector.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/feeder_lead.hpp"
#include "lamina/control/program/planned_correction.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/control_layers.hpp"
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
  EXPECT_NE(corrector.hear(constantMap(1, 0.5, 3)).find("on its way"), std::string::npos);
  CorrectionMap expected = latest;
  expected.toolpath_id = toolpathId(programmed().toolpath);
  EXPECT_EQ(sent(corrector), correctedProgram(textOf(beads()), programmed().toolpath, {expected}, {}).text);
  const std::vector<LayerDecision> decisions = corrector.decisions();
  ASSERT_EQ(decisions.size(), 3U);
  EXPECT_EQ(decisions[0].digest, "");
  EXPECT_EQ(decisions[1].digest, digestOf(latest));
  EXPECT_EQ(decisions[1].sequence, 2U);
  EXPECT_EQ(decisions[2].digest, "");
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

TEST(LayerCorrector, RecordsWhatWasAppliedSoThatItCanBeLaidAgain) {
  const test::ScratchFolder folder;
  StreamCorrectionSettings settings = used();
  settings.folder = folder.file("record");
  LayerCorrector corrector(beadProgram(), programmed(), settings);
  const CorrectionMap map = constantMap(2, 0.2);
  EXPECT_EQ(corrector.hear(map), "");
  const std::string laid = sent(corrector);
  EXPECT_EQ(corrector.recordFailure(), "");
  const std::string record = readFile(settings.folder + "/record.csv");
  EXPECT_NE(record.find("# toolpath " + toolpathId(beads())), std::string::npos) << record;
  EXPECT_NE(record.find("layer,sequence,digest\n0,0,none\n1,0,none\n2,1," + digestOf(map) + "\n"),
            std::string::npos)
      << record;
  const std::string kept = readFile(settings.folder + "/layer_2.csv");
  EXPECT_EQ(digestOf(readCorrectionMap(kept, "layer_2.csv")), digestOf(map));
  const PlannedCorrection again{
      readProgrammedToolpath(readFile(settings.folder + "/toolpath.csv"), "toolpath.csv"),
      readCorrectionFiles(settings.folder), settings.loop};
  EXPECT_EQ(correctedByMaps("beads", textOf(beads()), again).text, laid) << "made again from the record";
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
  EXPECT_EQ(LayerCorrector(beadProgram(), programmed(), {true, "", settings.loop, ""}).waitTime(), 5.0);
}

}  // namespace
}  // namespace lamina
