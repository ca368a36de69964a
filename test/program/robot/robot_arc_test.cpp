// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Waits of a toolpath, statements of arc packages, and what else a program states beside its toolpath.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <functional>

#include "lamina/base/error.hpp"
#include "lamina/program/rapid/reader/rapid_reader.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "program/robot/fanuc/fanuc_parser.hpp"
#include "support/rapid_programs.hpp"
#include "support/robot_programs.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::robotFiles;

bool hasText(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string refusedWith(const std::function<void()>& run) {
  try {
    run();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

RobotProgramSettings byArc(int weave = 0) {
  RobotProgramSettings settings;
  settings.arc.process = RobotProcess::Schedules;
  settings.arc.start_schedule = 6;
  settings.arc.end_schedule = 7;
  settings.arc.weave_schedule = weave;
  settings.krl.arc_on = "ARC_ON( {schedule},  {weave} )";
  settings.krl.arc_off = "ARC_OFF({schedule})";
  return settings;
}

Toolpath withDwells(Toolpath toolpath, std::uint64_t seed) {
  Random random(seed);
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths)
      for (std::size_t m = 0; m <= path.motionCount(); ++m)
        if (random.below(4) == 0) path.events.push_back({m, Dwell{random.uniform(0.01, 900.0)}});
  if (random.below(2) == 0) toolpath.events_at_end.emplace_back(Dwell{2.5});
  return toolpath;
}

/// Waits by the moves before them; those behind a path and before the next one are the same.
std::vector<double> waitsOf(const Toolpath& toolpath) {
  std::vector<double> waits(1, 0.0);
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t m = 0; m <= path.motionCount(); ++m) {
        waits.back() += dwellBefore(path.events, m);
        if (m < path.motionCount()) waits.push_back(0.0);
      }
  for (const ToolpathEvent& event : toolpath.events_at_end) waits.back() += std::get<Dwell>(event).duration_s;
  return waits;
}

void expectSameWaits(const Toolpath& read, const Toolpath& written, double step_s) {
  validate(read);
  RC_ASSERT(totals(read).waypoints == totals(written).waypoints);
  const std::vector<double> found = waitsOf(read);
  const std::vector<double> expected = waitsOf(written);
  RC_ASSERT(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) RC_ASSERT(std::abs(found[i] - expected[i]) <= step_s);
}

class RobotArc : public testing::TestWithParam<RobotLanguage> {
 protected:
  bool hasArcs() const { return GetParam() != RobotLanguage::UrScript; }
  RobotProgramSettings settings() const { return hasArcs() ? byArc() : RobotProgramSettings{}; }
  /// Half of the last decimal of a wait, of three of them.
  double step() const {
    const bool is_hundredths = GetParam() == RobotLanguage::Fanuc || GetParam() == RobotLanguage::Inform;
    return is_hundredths ? 0.0201 : 0.00151;
  }
  std::string file() const { return std::string("a") + suffixOf(GetParam()); }
};

TEST_P(RobotArc, WaitsAreReadBackWhereTheyWere) {
  const RobotLanguage language = GetParam();
  const double step_s = step();
  const bool has_arcs = hasArcs();
  EXPECT_TRUE(rc::check([=](std::uint64_t seed) {
    const Toolpath toolpath = withDwells(test::tilted(test::randomToolpath(seed), seed), seed);
    RobotProgramSettings settings =
        has_arcs && seed % 2 == 0 ? byArc(seed % 3 == 0 ? 4 : 0) : RobotProgramSettings{};
    settings.process_lead_s = 0.5;
    settings.process_end_s = 0.25;
    settings.may_cut = true;
    settings.krl.max_lines = settings.fanuc.max_lines = 100 + static_cast<int>(seed % 50);
    settings.urscript.max_points = settings.inform.max_points = 4 + static_cast<int>(seed % 30);
    expectSameWaits(readRobotProgram(robotFiles(language, toolpath, settings), "part"), toolpath, step_s);
  }));
}

TEST_P(RobotArc, ReadsOrRefusesAnyMutatedText) {
  const std::string whole =
      robotFiles(GetParam(), withDwells(test::tilted(test::twoLayers(), 1), 3), settings())[0].text;
  const std::string name = file();
  EXPECT_TRUE(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    std::string mutated = whole;
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
      const std::size_t at = random.below(mutated.size());
      const std::size_t from = random.below(mutated.size());
      if (random.below(2) == 0)
        mutated.erase(at, 1 + random.below(40));
      else
        mutated.insert(at, mutated.substr(from, 1 + random.below(40)));
    }
    try {
      validate(readRobotProgram({{name, mutated}}, "part"));
    } catch (const InvalidProgram& error) {
      RC_ASSERT(std::string(error.what()).find('\'') != std::string::npos);
    }
  }));
}

INSTANTIATE_TEST_SUITE_P(Languages, RobotArc, testing::ValuesIn(kRobotLanguages), [](const auto& language) {
  return std::string(suffixOf(language.param)).substr(1);
});

TEST(RobotWaits, AreStatementsOfTheirLanguages) {
  Toolpath toolpath = test::twoLayers();
  toolpath.layers[0].paths[1].events = {{0, Dwell{400.5}}};
  const auto text = [&](RobotLanguage language) { return robotFiles(language, toolpath)[0].text; };
  EXPECT_TRUE(hasText(text(RobotLanguage::Krl), "$OUT[1]=FALSE\n;# dwell\nWAIT SEC 400.5\n;# path travel"));
  EXPECT_TRUE(hasText(text(RobotLanguage::UrScript),
                      "set_standard_digital_out(1, False)\n  ## dwell\n  sleep(400.5)\n  ## path travel"));
  // No longer than the controllers take.
  const std::string fanuc = text(RobotLanguage::Fanuc);
  EXPECT_TRUE(hasText(fanuc, "!# dwell ;\n")) << fanuc;
  EXPECT_TRUE(hasText(fanuc, "  WAIT 327.67(sec) ;\n")) << fanuc;
  EXPECT_TRUE(hasText(fanuc, "  WAIT 72.83(sec) ;\n")) << fanuc;
  EXPECT_TRUE(hasText(text(RobotLanguage::Inform), "'# dwell\r\nTIMER T=400.50\r\n"));
  toolpath.layers[0].paths[1].events = {{0, Dwell{700.0}}};
  EXPECT_TRUE(hasText(text(RobotLanguage::Inform), "TIMER T=655.35\r\nTIMER T=44.65\r\n"));
}

TEST(RobotWaits, TheTipStandsWhereItWaits) {
  Toolpath toolpath = test::twoLayers();
  toolpath.layers[0].paths[0].events = {{2, Dwell{1.0}}};
  const std::string text = robotFiles(RobotLanguage::Krl, toolpath)[0].text;
  EXPECT_TRUE(
      hasText(text, "LIN {X 10.000,Y 10.000,Z 0.200,A 0.0000,B 0.0000,C 180.0000}\n;# dwell\nWAIT SEC 1\n"))
      << text;
}

TEST(RobotWaits, RefusesOneBeforeTheFirstMove) {
  std::string text = robotFiles(RobotLanguage::Krl, test::twoLayers())[0].text;
  text.insert(text.find(";# layer"), ";# dwell\nWAIT SEC 1\n");
  try {
    readRobotProgram({{"a.src", text}}, "part");
    FAIL();
  } catch (const InvalidProgram& error) {
    EXPECT_TRUE(hasText(error.what(), "waits before the first path")) << error.what();
  }
}

TEST(RobotArcs, AreStatementsOfTheirLanguages) {
  const Toolpath toolpath = test::twoLayers();
  const std::string krl = robotFiles(RobotLanguage::Krl, toolpath, byArc(4))[0].text;
  EXPECT_TRUE(hasText(krl, ";# arc_on ARC_ON( 6, 4 )\n;# arc_off ARC_OFF(7)\n")) << krl;
  EXPECT_TRUE(hasText(krl, "C 180.0000}\nARC_ON( 6, 4 )\nLIN {X 10.000")) << krl;
  EXPECT_TRUE(hasText(krl, "C 180.0000}\nARC_OFF(7)\n")) << krl;
  EXPECT_FALSE(hasText(krl, "$OUT"));
  const std::string fanuc = robotFiles(RobotLanguage::Fanuc, toolpath, byArc(4))[0].text;
  EXPECT_TRUE(hasText(fanuc, "FINE\n    :  Arc Start[6]    ;\n")) << fanuc;
  EXPECT_TRUE(hasText(fanuc, ":  Weave Sine[4] ;\n")) << fanuc;
  EXPECT_TRUE(hasText(fanuc, "FINE\n    :  Arc End[7]    ;\n")) << fanuc;
  EXPECT_TRUE(hasText(fanuc, ":  Weave End ;\n")) << fanuc;
  const std::string inform = robotFiles(RobotLanguage::Inform, toolpath, byArc(4))[0].text;
  EXPECT_TRUE(hasText(inform, "PL=0\r\nARCON ASF#(6)\r\nWVON WEV#(4)\r\nMOVL")) << inform;
  EXPECT_TRUE(hasText(inform, "PL=0\r\nWVOF\r\nARCOF AEF#(7)\r\n")) << inform;
}

// By hand from saved jobs: the section of the application, the speed of the schedule.
TEST(RobotArcs, FanucNamesItsEquipmentAndTheSpeedOfTheSchedule) {
  RobotProgramSettings settings = byArc(6);
  settings.arc.end_schedule = 6;
  settings.fanuc.weld_speed = FanucWeldSpeed::Schedule;
  const Toolpath toolpath = test::twoLayers();
  const std::string text = robotFiles(RobotLanguage::Fanuc, toolpath, settings)[0].text;
  EXPECT_TRUE(hasText(text,
                      "CONTROL_CODE\t= 00000000 00000000;\n/APPL\n  ARC : TRUE ; \n  ARC Welding Equipment : "
                      "1,*,*,*,*;\n/MN\n"))
      << text;
  EXPECT_TRUE(hasText(text, "!# weld_speed 30 ;\n")) << text;
  EXPECT_TRUE(hasText(text, "FINE\n    :  Arc Start[6]    ;\n")) << text;
  EXPECT_TRUE(hasText(text, ":  Weave Sine[6] ;\n")) << text;
  EXPECT_TRUE(hasText(text, "] WELD_SPEED CNT100    ;\n")) << text;
  EXPECT_TRUE(hasText(text, "] WELD_SPEED FINE\n    :  Arc End[6]    ;\n")) << text;
  const Toolpath read = readRobotProgram({{"a.ls", text}}, "part");
  for (std::size_t p = 0; p < 2; ++p)
    EXPECT_NEAR(read.layers[0].paths[p].feed_mm_s.at(1), toolpath.layers[0].paths[p].feed_mm_s.at(1), 1e-6);
  settings.fanuc.arc_equipment = 3;
  EXPECT_TRUE(hasText(robotFiles(RobotLanguage::Fanuc, toolpath, settings)[0].text, ": *,*,1,*,*;\n"));
  settings.fanuc.arc_equipment = 0;
  EXPECT_FALSE(hasText(robotFiles(RobotLanguage::Fanuc, toolpath, settings)[0].text, "/APPL"));
  EXPECT_FALSE(hasText(robotFiles(RobotLanguage::Fanuc, toolpath)[0].text, "/APPL"));
}

TEST(RobotArcs, AWeldSpeedIsOneAndStated) {
  RobotProgramSettings settings = byArc();
  settings.fanuc.weld_speed = FanucWeldSpeed::Schedule;
  Toolpath toolpath = test::twoLayers();
  toolpath.layers[1].paths[0].feed_mm_s = 20.0;
  EXPECT_TRUE(hasText(refusedWith([&] { robotFiles(RobotLanguage::Fanuc, toolpath, settings); }),
                      "expected one speed, that of the schedule"));
  settings.arc.process = RobotProcess::Outputs;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  settings.arc.process = RobotProcess::Schedules;
  std::string text = robotFiles(RobotLanguage::Fanuc, test::twoLayers(), settings)[0].text;
  const std::string note = "!# weld_speed 30 ;";
  text.replace(text.find(note), note.size(), "! ;");
  try {
    readRobotProgram({{"a.ls", text}}, "part");
    FAIL();
  } catch (const InvalidProgram& error) {
    EXPECT_TRUE(hasText(error.what(), "WELD_SPEED")) << error.what();
  }
}

TEST(RobotArcs, ValuesStandBeforeTheArc) {
  RobotProgramSettings settings = byArc();
  settings.levels = "laser_power_w=1*0.0025, wire_speed_mm_s=2*0.01";
  const Toolpath toolpath = test::withValues(test::twoLayers(), 1);
  const std::string text = robotFiles(RobotLanguage::Fanuc, toolpath, settings)[0].text;
  EXPECT_TRUE(hasText(text, ":  Arc Start[6]    ;\n"));
  EXPECT_FALSE(hasText(text, "    :  Arc Start")) << text;  // a statement of its own behind AO
  const Toolpath read = readRobotProgram({{"a.ls", text}}, "part");
  EXPECT_EQ(read.layers[0].paths[0].values.size(), toolpath.layers[0].paths[0].values.size());
}

TEST(RobotArcs, RefuseWhatALanguageDoesNotHave) {
  const Toolpath toolpath = test::twoLayers();
  const auto refusal = [&](RobotLanguage language, const RobotProgramSettings& settings) {
    return refusedWith([&] { robotFiles(language, toolpath, settings); });
  };
  EXPECT_TRUE(hasText(refusal(RobotLanguage::UrScript, byArc()),
                      "robot_program.process is 'schedules'; expected 'outputs': URScript"));
  RobotProgramSettings settings = byArc();
  settings.krl.arc_on.clear();
  EXPECT_TRUE(hasText(refusal(RobotLanguage::Krl, settings), "krl.arc_on is ''"));
  EXPECT_EQ(refusal(RobotLanguage::Fanuc, settings), "");
  settings = byArc(3);
  settings.krl.arc_on = "ARC_ON({schedule})";
  EXPECT_TRUE(
      hasText(refusal(RobotLanguage::Krl, settings), "robot_program.weave_schedule 3; expected {weave}"));
  settings = byArc();
  settings.krl.arc_off = settings.krl.arc_on;
  EXPECT_TRUE(hasText(refusal(RobotLanguage::Krl, settings), "must differ"));
  // None that somebody has chosen.
  for (const RobotLanguage language : {RobotLanguage::Krl, RobotLanguage::Fanuc, RobotLanguage::Inform}) {
    settings = byArc();
    settings.arc.start_schedule = 0;
    EXPECT_TRUE(
        hasText(refusal(language, settings),
                "robot_program.start_schedule is 0 with robot_program.process 'schedules'; expected"));
    settings = byArc();
    settings.arc.end_schedule = 0;
    EXPECT_TRUE(hasText(refusal(language, settings), "robot_program.end_schedule is 0"));
  }
  settings.krl.arc_on = "ARC_ON(WDAT1)";
  settings.krl.arc_off = "ARC_OFF(WDAT1)";
  EXPECT_EQ(refusal(RobotLanguage::Krl, settings), "");
  settings = {};
  settings.arc.weave_schedule = 2;
  EXPECT_TRUE(hasText(refusal(RobotLanguage::Fanuc, settings), "robot_program.weave_schedule is 2"));
}

StatedEquipment equipmentOf(RobotLanguage language, const RobotProgramSettings& settings) {
  return readEquippedRobotProgram(robotFiles(language, test::twoLayers(), settings), "part").equipment;
}

std::string equipmentRefusal(const StatedEquipment& read, const StatedEquipment& written) {
  return refusedWith([&] { requireSameEquipment(read, written, "a.ls", "robot_program.*"); });
}

TEST(StatedEquipment, DistinguishesArcsFromOutputsAndFromOtherArcs) {
  for (const RobotLanguage language : {RobotLanguage::Krl, RobotLanguage::Fanuc, RobotLanguage::Inform}) {
    const StatedEquipment weaving = equipmentOf(language, byArc(4));
    EXPECT_EQ(equipmentRefusal(weaving, equipmentOf(language, byArc(4))), "");
    EXPECT_TRUE(hasText(equipmentRefusal(weaving, equipmentOf(language, {})), "expected 'output 1', as it"));
    EXPECT_NE(equipmentRefusal(weaving, equipmentOf(language, byArc(5))), "") << toString(language);
    EXPECT_NE(equipmentRefusal(weaving, equipmentOf(language, byArc())), "") << toString(language);
  }
  EXPECT_EQ(
      equipmentRefusal(equipmentOf(RobotLanguage::Fanuc, byArc(4)), equipmentOf(RobotLanguage::Fanuc, {})),
      "the process of 'a.ls' is switched by 'arc end by schedule 7', 'arc start by schedule 6', 'weave by "
      "schedule 4'; expected 'output 1', as it would be written anew by robot_program.*");
}

TEST(StatedEquipment, HoldsOutputsLevelsAndWaitsOfTheProcess) {
  RobotProgramSettings settings;
  settings.process_output = 3;
  settings.process_lead_s = 0.5;
  settings.levels = "laser_power_w=2*0.0025";
  for (const RobotLanguage language : {RobotLanguage::Krl, RobotLanguage::Fanuc, RobotLanguage::Inform})
    EXPECT_EQ(
        equipmentOf(language, settings).process,
        (std::set<std::string>{"output 3", "wait of 0.5 s", "analogue output 2 of laser_power_w by 0.0025"}))
        << toString(language);
}

TEST(StatedEquipment, HoldsExternalAxesAndACarriedBed) {
  const std::string plain = robotFiles(RobotLanguage::Krl, test::twoLayers())[0].text;
  const auto read = [](const std::string& text) {
    return readEquippedRobotProgram({{"a.src", text}}, "part").equipment;
  };
  std::string text = plain;
  const std::string end = "C 180.0000}";
  for (std::size_t at = text.find(end); at != std::string::npos; at = text.find(end, at + 1))
    text.replace(at, end.size(), "C 180.0000,E1 100.5}");
  EXPECT_EQ(equipmentRefusal(read(text), read(plain)),
            "the external axes of 'a.ls' are 1 (100.5 at all moves); expected none, as it would be written "
            "anew by robot_program.*");
  text.replace(text.rfind("E1 100.5"), 8, "E1 101.5");
  EXPECT_TRUE(
      hasText(equipmentRefusal(read(text), read(plain)), "1 (100.5 at the first move, others later)"));
  text = plain;
  text.insert(text.find(";# layer"), ";# carried_bed 0 0 300 1 0 0 0\n");
  EXPECT_TRUE(hasText(equipmentRefusal(read(text), read(plain)),
                      "the bed of 'a.ls' is carried by an external axis; expected one that stands still"));
}

TEST(RobotReaderOfFanuc, ReadsTheStatementsThatGoOnInTheNextLine) {
  constexpr int kArcs = 400;
  std::string text = "/PROG A\n/MN\n";
  for (int i = 0; i < kArcs; ++i) text += "   1:L P[1] 10mm/sec FINE\n    :  Arc Start[6]    ;\n";
  text +=
      "/POS\nP[1]{\n   GP1:\n    UF : 1, UT : 1,\n    CONFIG : 'N U T, 0, 0, 0',\n    X = 1.0 mm, Y = 2.0 "
      "mm, "
      "Z = 3.0 mm,\n    W = 180.0 deg, P = 0.0 deg, R = 0.0 deg\n};\n/END\n";
  EXPECT_EQ(parseFanuc({"a.ls", text, "", std::nullopt}).size(), 2U * kArcs);
}

RapidSettings rapidArc() {
  RapidSettings settings;
  settings.process = RapidProcess::Arc;
  settings.weave_data = "weave1";
  return settings;
}

TEST(RapidArcs, AreMovesOfTheArcPackage) {
  const std::vector<std::string> modules = test::rapidModules(test::twoLayers(), rapidArc());
  const std::vector<std::string> lines = test::pointLines(modules);
  EXPECT_EQ(test::countOf(lines, "ArcLStart "), 2U);
  EXPECT_EQ(test::countOf(lines, "ArcLEnd "), 2U);
  EXPECT_EQ(test::countOf(lines, "ArcL "), 3U);
  EXPECT_EQ(test::countOf(lines, "MoveL "), 0U);
  EXPECT_TRUE(hasText(lines[0], "seam1,weld1\\Weave:=weave1,fine,t_cursoDic\\WObj:=temple;")) << lines[0];
  for (const char* output : {"Haz_ON", "SolicitudGas", "SolicitudLaser"})
    EXPECT_FALSE(hasText(modules[0], output)) << output;
}

TEST(RapidArcs, AreReadBackWithTheirWaits) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Toolpath toolpath = withDwells(test::tilted(test::randomToolpath(seed), seed), seed);
    RapidSettings settings = seed % 2 == 0 ? rapidArc() : RapidSettings{};
    settings.max_points = seed % 3 == 0 ? 5 : 0;
    std::vector<RapidText> modules;
    const std::vector<std::string> texts = test::rapidModules(toolpath, settings);
    for (const std::string& text : texts) modules.push_back({"m.mod", text});
    const Toolpath read = readRapid(modules, "part");
    expectSameWaits(read, toolpath, 0.00151);
    for (std::size_t l = 0; l < read.layers.size(); ++l)
      for (std::size_t p = 0; p < read.layers[l].paths.size(); ++p)
        RC_ASSERT(read.layers[l].paths[p].role == toolpath.layers[l].paths[p].role);
  }));
}

TEST(StatedEquipment, OfRapidHoldsDataSignalsAxesAndTheUnitThatCarriesTheBed) {
  const auto read = [](const std::string& text) {
    return readEquippedRapid({{"m.mod", text}}, "part").equipment;
  };
  const auto written = [](const RapidSettings& settings) {
    return test::rapidModules(test::twoLayers(), settings)[0];
  };
  const std::string plain = written({});
  const std::string what = equipmentRefusal(read(written(rapidArc())), read(plain));
  EXPECT_TRUE(
      hasText(what, "switched by 'seam data seam1', 'weave data weave1', 'weld data weld1'; expected '"))
      << what;
  EXPECT_TRUE(hasText(what, "'set solicitudlaser'")) << what;
  EXPECT_EQ(equipmentRefusal(read(plain), read(plain)), "");
  RapidSettings other;
  other.laser_off_wait_s = 2.0;
  EXPECT_TRUE(hasText(equipmentRefusal(read(written(other)), read(plain)), "'wait of 2 s'"));
  other = {};
  other.positioner = "STN1";
  EXPECT_TRUE(hasText(equipmentRefusal(read(written(other)), read(plain)), "is carried by STN1"));
  std::string turned = plain;
  turned.replace(turned.rfind("[0.000,9e+09"), 12, "[9.500,9e+09");
  EXPECT_TRUE(hasText(equipmentRefusal(read(turned), read(plain)), "1 (0 at the first move, others later)"));
}

TEST(RapidArcs, RefuseWhatCannotBe) {
  const auto refusal = [](const RapidSettings& settings) {
    return refusedWith([&] { test::rapidModules(test::twoLayers(), settings); });
  };
  RapidSettings settings = rapidArc();
  settings.variant = RapidVariant::Wire3Axes;
  EXPECT_TRUE(hasText(refusal(settings), "rapid.process is 'arc' with rapid.variant 'wire_3_axes'"));
  settings = rapidArc();
  settings.seam_data = "1seam";
  EXPECT_TRUE(hasText(refusal(settings), "rapid.seam_data is '1seam'"));
  settings = {};
  settings.weave_data = "weave1";
  EXPECT_TRUE(hasText(refusal(settings), "rapid.weave_data is 'weave1' with rapid.process 'outputs'"));
  std::string text = test::rapidModules(test::twoLayers(), rapidArc())[0];
  text.replace(text.find("ArcLStart"), 9, "MoveL");
  text.replace(text.find("seam1,weld1\\Weave:=weave1,"), 26, "");
  try {
    readRapid({{"m.mod", text}}, "part");
    FAIL();
  } catch (const InvalidProgram& error) {
    EXPECT_TRUE(hasText(error.what(), "expected ArcLStart before it")) << error.what();
  }
}

}  // namespace
}  // namespace lamina
