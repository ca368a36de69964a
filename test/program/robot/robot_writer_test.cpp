// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/robot/robot_writer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/program/robot/robot_angles.hpp"
#include "lamina/program/robot/speed_rounding.hpp"
#include "program/robot/whole_speed.hpp"
#include "program/robot/writer/robot_printer.hpp"
#include "support/rapid_programs.hpp"
#include "support/robot_programs.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::robotFiles;

std::string robotListing(const std::string& name) {
  return readFile(std::string(LAMINA_SOURCE_DIR) + "/test/data/robot/" + name);
}

std::string refusalOf(const std::function<void()>& run) {
  try {
    run();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t countIn(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// What a language prints of statements, in a file of its own.
std::string printed(RobotLanguage language, const std::vector<RobotStatement>& statements,
                    const RobotProgramSettings& settings = {}) {
  const RobotSite site{settings, std::nullopt, controllerMap(language, settings), {}};
  const auto printer = robotDialect(language, settings).open(site);
  for (const RobotStatement& statement : statements) printer->print(statement);
  return printer->files({"P", {}, "part"}).front().text;
}

/// A pose of a public robot at joints 10, -20, 30, -40, 50, -60 deg.
TipMove poseAt(const Point3& point, const Eigen::Quaterniond& turn, double feed_mm_s) {
  TipMove move;
  move.point = point;
  move.orientation = turn;
  move.feed_mm_s = feed_mm_s;
  move.room_mm = 10.0;
  return move;
}

// Listings were written by hand from the languages' grammars.
TEST(RobotProgram, IsTheListingOfEachLanguage) {
  const Toolpath toolpath = test::twoLayers();
  for (const auto& [language, name] :
       std::vector<std::pair<RobotLanguage, std::string>>{{RobotLanguage::Krl, "two_layers.src"},
                                                          {RobotLanguage::UrScript, "two_layers.script"},
                                                          {RobotLanguage::Fanuc, "TWO_LAYERS.ls"},
                                                          {RobotLanguage::Inform, "TWO_LAYERS.jbi"}}) {
    const std::vector<RobotFile> files = robotFiles(language, toolpath);
    ASSERT_EQ(files.size(), 1U) << name;
    EXPECT_EQ(files[0].name, name);
    EXPECT_EQ(files[0].text, robotListing(name));
  }
}

TEST(RobotProgram, KrlStatesJointsAndPosesOfAPublicRobot) {
  const ControllerJoints joints{{10, -20, 30, -40, 50, -60}, {}};
  const TipMove move =
      poseAt({1625.297, -207.584, 647.816}, rotationOfAngles(RobotAngles{137.981, -21.855, 100.385}), 8.0);
  const std::string text =
      printed(RobotLanguage::Krl, {JointMove{joints}, LevelChange{1, 0.3, true}, move, ProgramWait{1.5}});
  EXPECT_TRUE(holds(text,
                    "PTP {A1 10.0000,A2 -20.0000,A3 30.0000,A4 -40.0000,A5 50.0000,A6 -60.0000}\n"
                    "TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=0.3\n"
                    "$VEL.CP=0.008\n"
                    "LIN {X 1625.297,Y -207.584,Z 647.816,A 100.3850,B -21.8550,C 137.9810} C_DIS\n"))
      << text;
  EXPECT_TRUE(holds(text, "C_DIS\nWAIT SEC 1.5\nEND\n")) << text;
}

TEST(RobotProgram, KrlPutsPointsIntoItsDataFileIfAsked) {
  RobotProgramSettings settings;
  settings.krl.points = KrlPoints::Dat;
  const std::vector<RobotFile> files = robotFiles(RobotLanguage::Krl, test::twoLayers(), settings);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[1].name, "two_layers.dat");
  EXPECT_TRUE(holds(files[0].text, "LIN XP2 C_DIS\n"));
  EXPECT_EQ(files[1].text.rfind("DEFDAT two_layers\nDECL E6POS XP1={X 0.000,Y 0.000,Z 0.200,A 0.0000,", 0),
            0U);
  EXPECT_TRUE(holds(files[1].text,
                    "DECL E6POS XP7={X 10.000,Y 0.000,Z 0.400,A 0.0000,B 0.0000,C 180.0000}\nENDDAT\n"));
}

TEST(RobotProgram, UrScriptStatesAPublicRobotsPoseInMetresAndRotationVector) {
  // Over base, which is turned by 180 deg about z from base_link.
  const Eigen::Quaterniond turn = rotationOfVector(Eigen::Vector3d(1.277558, 0.522089, -1.754865));
  TipMove move = poseAt({-1213.229, -466.834, 231.855}, turn, 250.0);
  const std::string text = printed(RobotLanguage::UrScript, {move});
  EXPECT_TRUE(holds(
      text,
      "movel(p[-1.213229, -0.466834, 0.231855, 1.277558, 0.522089, -1.754865], a=1.2, v=0.25, r=0.0005)\n"))
      << text;
}

TEST(RobotProgram, UrScriptBlendsNeverMeetAndOutputsWaitForThePoint) {
  TipMove move = poseAt({0, 0, 0}, Eigen::Quaterniond::Identity(), 10.0);
  move.lays = true;
  move.room_mm = 1.0;  // 0.45 of it
  EXPECT_TRUE(holds(printed(RobotLanguage::UrScript, {move}), "r=0.00045)"));
  move.room_mm = 0.04;  // too near for a blend
  EXPECT_TRUE(holds(printed(RobotLanguage::UrScript, {move}), "r=0)"));
  move.room_mm = 1.0;
  const std::string text = printed(RobotLanguage::UrScript, {move, LevelChange{0, 0.25, true}, move});
  EXPECT_TRUE(holds(text, "r=0)\n  set_standard_analog_out(0, 0.25)\n  movep(")) << text;
}

// M-20iA at URDF joints 10, -20, 30, -40, 50, -60 deg.
TEST(RobotProgram, FanucCountsJoint3FromLevel) {
  const ControllerMap map = controllerMap(RobotLanguage::Fanuc, {});
  EXPECT_EQ(map.joint_3_from_2, -1.0);
  EXPECT_EQ(controllerMap(RobotLanguage::Krl, {}).joint_3_from_2, 0.0);
  TipMove move =
      poseAt({226.572, -10.049, 1629.662}, rotationOfAngles(RobotAngles{1.812, 29.536, -80.551}), 6.7);
  move.lays = true;
  move.posture = ArmPosture{{{10, -20, 50, -190, 50, 190}, {}}, 4};
  const std::string text = printed(RobotLanguage::Fanuc, {move});
  EXPECT_TRUE(
      holds(text, "\tX =   226.572  mm,\tY =   -10.049  mm,\tZ =  1629.662  mm,\n\tW =     1.812 deg,"))
      << text;
  EXPECT_TRUE(holds(text, "P =    29.536 deg,\tR =   -80.551 deg")) << text;
  // Joint 5 positive: flipped. Wrist behind axis 1: back. Joints 4 and 6 beyond half a turn.
  EXPECT_TRUE(holds(text, "CONFIG : 'F U B, 0, -1, 1',")) << text;
  EXPECT_TRUE(holds(text, "L P[1] 40cm/min CNT100    ;")) << text;
}

TEST(RobotProgram, WholeSpeedsAreInTheUnitOfLeastError) {
  const std::vector<SpeedUnit> units = {{"cm/min", 10.0 / 60.0, 1.0, 12000.0},
                                        {"mm/sec", 1.0, 1.0, 2000.0},
                                        {"inch/min", 25.4 / 60.0, 1.0, 4724.0}};
  EXPECT_EQ(roundedSpeed(8.0, units).value, 48.0);
  EXPECT_EQ(roundedSpeed(8.0, units).unit.name, "cm/min");
  EXPECT_EQ(roundedSpeed(6.7, units).value, 40.0);
  // 6.35 mm/s: 15 inch/min exactly, 38 cm/min 0.26 % off.
  EXPECT_EQ(roundedSpeed(6.35, units).unit.name, "inch/min");
  EXPECT_EQ(roundedSpeed(2000.0, units).value * roundedSpeed(2000.0, units).unit.mm_s, 2000.0);
  // 0.1 mm/s: 1 cm/min is 67 % off.
  EXPECT_TRUE(holds(refusalOf([&] { roundedSpeed(0.1, units); }),
                    "a feed is 0.1 mm/s; the nearest that can be written is 1 cm/min"));
  EXPECT_TRUE(holds(refusalOf([&] { roundedSpeed(3000.0, units); }), "expected 2 % at most"));
}

TEST(RobotProgram, ReportsHowFarItsSpeedsAreRounded) {
  Toolpath toolpath = test::twoLayers();
  const auto rounding = [&](RobotLanguage language) { return speedRounding(toolpath, language, {}); };
  EXPECT_EQ(rounding(RobotLanguage::Fanuc).motions, 0U);  // 30 mm/s: 180 cm/min
  toolpath.layers[1].paths[0].feed_mm_s = 6.7;
  const SpeedRounding fanuc = rounding(RobotLanguage::Fanuc);
  EXPECT_EQ(fanuc.motions, 1U);
  EXPECT_NEAR(fanuc.greatest_share, 1.0 - 40.0 / 6.0 / 6.7, 1e-12);  // 40 cm/min
  EXPECT_EQ(fanuc.feed_mm_s, 6.7);
  EXPECT_NEAR(fanuc.written_mm_s, 40.0 / 6.0, 1e-12);
  EXPECT_EQ(rounding(RobotLanguage::Inform).motions, 0U);
  toolpath.layers[1].paths[0].feed_mm_s = 6.74;
  EXPECT_NEAR(rounding(RobotLanguage::Inform).greatest_share, 0.04 / 6.74, 1e-12);
  EXPECT_EQ(rounding(RobotLanguage::Krl).motions, 0U);
  EXPECT_EQ(rounding(RobotLanguage::UrScript).motions, 0U);
}

TEST(RobotProgram, InformStatesPulsesWhereTheyAreKnownAndThePosture) {
  RobotProgramSettings settings;
  settings.inform.pulses_per_deg = {1000, 1000, 1000, 500, 500, 250.5};
  settings.inform.speed_unit = InformSpeedUnit::CentimetresPerMinute;
  TipMove move = poseAt({1, 2, 3}, Eigen::Quaterniond::Identity(), 8.0);
  move.posture = ArmPosture{{{10, -20, 30, 200, -50, 0}, {}}, 2 + 4};
  const ControllerJoints joints{{10, -20, 30, -40, 50, -60}, {}};
  const std::string text = printed(RobotLanguage::Inform, {JointMove{joints}, move}, settings);
  EXPECT_TRUE(holds(text,
                    "///NPOS 2,0,0,0,0,0\r\n///TOOL 1\r\n///POSTYPE PULSE\r\n///PULSE\r\n"
                    "C00000=10000,-20000,30000,-20000,25000,-15030\r\n"))
      << text;
  // Joint 5 negative: no flip. Lower, rear, joint 4 beyond half a turn.
  EXPECT_TRUE(holds(text, "///RCONF 1,1,1,1,0,0,0,0\r\n")) << text;
  EXPECT_TRUE(holds(text, "MOVJ C00000 VJ=10.00\r\nMOVL C00001 V=48.0 PL=1\r\n")) << text;
  settings.inform.rconf_order = InformRconfOrder::FrontElbowFlip;
  settings.inform.flip = JointSign::Negative;
  settings.inform.rconf_length = 6;
  EXPECT_TRUE(holds(printed(RobotLanguage::Inform, {move}, settings), "///RCONF 1,1,0,1,0,0\r\n"));
}

// Yaskawa's manuals list PULSE, BASE, ROBOT, TOOL, USER and MTOOL as types of points, but no degrees.
TEST(RobotProgram, InformStatesThePoseOfAMoveOfTheJointsWherePulsesAreNotKnown) {
  TipMove pose = poseAt({1, 2, 3}, Eigen::Quaterniond::Identity(), 8.0);
  pose.posture = ArmPosture{{{10, -20, 30, 200, -50, 0}, {}}, 2 + 4};
  const ControllerJoints joints{{10, -20, 30, 200, -50, 0}, {}};
  const std::string text = printed(RobotLanguage::Inform, {JointMove{joints, pose}});
  EXPECT_TRUE(holds(text,
                    "///NPOS 1,0,0,0,0,0\r\n///USER 1\r\n///TOOL 1\r\n///POSTYPE USER\r\n///RECTAN\r\n"
                    "///RCONF 1,1,1,1,0,0,0,0\r\nC00000=1.000,2.000,3.000,0.0000,0.0000,0.0000\r\n"))
      << text;
  EXPECT_TRUE(holds(text, "'# stands 10.0000 -20.0000\r\n'#+ 30.0000 200.0000 -50.0000\r\n")) << text;
  EXPECT_TRUE(holds(text, "MOVJ C00000 VJ=10.00\r\n")) << text;
  EXPECT_TRUE(holds(refusalOf([&] { printed(RobotLanguage::Inform, {JointMove{joints}}); }),
                    "expected one, or inform.pulses_per_deg"));
}

/// Lines of Fanuc's statements, or of all of KRL.
std::size_t linesIn(const RobotFile& file) {
  if (file.name.find(".ls") == std::string::npos) return countIn(file.text, "\n");
  const std::size_t begin = file.text.find("/MN\n");
  return countIn(file.text.substr(begin, file.text.find("/POS") - begin), "\n") - 1;
}

TEST(RobotProgram, FilesKeepToTheLimitsOfTheirControllers) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Toolpath toolpath = test::randomToolpath(seed);
    RobotProgramSettings settings;
    settings.may_cut = true;
    settings.krl.max_lines = settings.fanuc.max_lines = 100;
    settings.urscript.max_points = settings.inform.max_points = 4 + static_cast<int>(seed % 9);
    for (const RobotLanguage language : kRobotLanguages) {
      const std::vector<RobotFile> files = robotFiles(language, toolpath, settings);
      for (const RobotFile& file : files) {
        if (language == RobotLanguage::Krl || language == RobotLanguage::Fanuc)
          RC_ASSERT(linesIn(file) <= 100U);
        if (language == RobotLanguage::UrScript)
          RC_ASSERT(countIn(file.text, "  move") <= static_cast<std::size_t>(settings.urscript.max_points));
        if (language == RobotLanguage::Inform)
          RC_ASSERT(countIn(file.text, "MOVL ") <= static_cast<std::size_t>(settings.inform.max_points));
      }
    }
  }));
}

TEST(RobotProgram, TheProcessIsOffWhereAFileEnds) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    RobotProgramSettings settings;
    settings.may_cut = true;
    settings.urscript.max_points = 4;
    for (const RobotFile& file : robotFiles(RobotLanguage::UrScript, test::randomToolpath(seed), settings)) {
      const std::size_t on = file.text.rfind("True)");
      const std::size_t off = file.text.rfind("False)");
      RC_ASSERT(on == std::string::npos || (off != std::string::npos && off > on));
    }
  }));
}

/// How a language switches the process and moves the tip.
struct SwitchWords {
  RobotLanguage language;
  std::string on;
  std::string off;
  std::string move;
};

TEST(RobotProgram, TheProcessStartsForMovesAlone) {
  const std::vector<SwitchWords> each = {
      {RobotLanguage::Krl, "$OUT[1]=TRUE", "$OUT[1]=FALSE", "LIN {"},
      {RobotLanguage::UrScript, "_out(1, True)", "_out(1, False)", "  move"},
      {RobotLanguage::Fanuc, "DO[1]=ON", "DO[1]=OFF", ":L P["},
      {RobotLanguage::Inform, "OT#(1) ON", "OT#(1) OFF", "MOVL "}};
  EXPECT_TRUE(rc::check([&each](std::uint64_t seed) {
    RobotProgramSettings settings;
    settings.may_cut = true;
    settings.krl.max_lines = settings.fanuc.max_lines = 90 + static_cast<int>(seed % 30);
    settings.urscript.max_points = settings.inform.max_points = 4 + static_cast<int>(seed % 9);
    for (const SwitchWords& words : each)
      for (const RobotFile& file : robotFiles(words.language, test::randomToolpath(seed), settings))
        for (std::size_t on = file.text.find(words.on); on != std::string::npos;
             on = file.text.find(words.on, on + 1)) {
          const std::size_t move = file.text.find(words.move, on);
          RC_ASSERT(move != std::string::npos);
          RC_ASSERT(move < file.text.find(words.off, on));
        }
  }));
}

TEST(RobotProgram, RefusesRunsLongerThanAFileUnlessTheyMayBeCut) {
  RobotProgramSettings settings;
  settings.urscript.max_points = 4;
  const std::string refusal =
      refusalOf([&] { robotFiles(RobotLanguage::UrScript, test::twoLayers(), settings); });
  EXPECT_TRUE(holds(refusal, "the run from layer 0, path 0 takes")) << refusal;
  EXPECT_TRUE(holds(refusal, "5 points of URScript")) << refusal;
  EXPECT_TRUE(holds(refusal, "urscript.max_points")) << refusal;
}

TEST(RobotProgram, RefusesWhatControllersCannotHave) {
  const Toolpath toolpath = test::twoLayers();
  const auto named = [&](RobotLanguage language, const std::string& name) {
    return refusalOf([&] { robotFiles(language, toolpath, {}, name); });
  };
  EXPECT_TRUE(holds(named(RobotLanguage::Krl, "1st"), "the program's name is '1st'"));
  EXPECT_TRUE(holds(named(RobotLanguage::Krl, std::string(25, 'a')), "at most 24 in KRL"));
  EXPECT_TRUE(holds(named(RobotLanguage::UrScript, "a b"), "a letter, then letters"));
  EXPECT_TRUE(holds(named(RobotLanguage::Fanuc, std::string(37, 'a')), "at most 36 in Fanuc TP"));
  EXPECT_TRUE(holds(named(RobotLanguage::Inform, ""), "at most 32 in INFORM"));
  EXPECT_TRUE(holds(named(RobotLanguage::Krl, "Loop"), "'Loop'"));
  EXPECT_TRUE(holds(named(RobotLanguage::UrScript, "end"), "a word of URScript itself"));
  RobotProgramSettings old;
  old.fanuc.name_length = 8;
  EXPECT_TRUE(
      holds(refusalOf([&] { robotFiles(RobotLanguage::Fanuc, toolpath, old); }), "at most 8 in Fanuc TP"));
  old.inform.name_length = 8;
  EXPECT_TRUE(
      holds(refusalOf([&] { robotFiles(RobotLanguage::Inform, toolpath, old); }), "at most 8 in INFORM"));
  RobotProgramSettings small;
  small.krl.max_mb = 0.0001;
  EXPECT_TRUE(
      holds(refusalOf([&] { robotFiles(RobotLanguage::Krl, toolpath, small); }), "expected 100 at most"));
  RobotProgramSettings bare;
  bare.tool_number = 0;
  EXPECT_TRUE(holds(refusalOf([&] { robotFiles(RobotLanguage::Krl, toolpath, bare); }),
                    "robot_program.tool_number is 0; expected 1 at least in KRL, whose TOOL_DATA has no 0"));
  for (const RobotLanguage language : {RobotLanguage::Fanuc, RobotLanguage::Inform})
    EXPECT_EQ(refusalOf([&] { robotFiles(language, toolpath, bare); }), "") << toString(language);
  bare.tool_number = 1;
  bare.frame_number = 0;
  EXPECT_TRUE(
      holds(refusalOf([&] { robotFiles(RobotLanguage::Krl, toolpath, bare); }), "whose BASE_DATA has no 0"));
  Toolpath far = toolpath;
  for (const RobotLanguage language : {RobotLanguage::Krl, RobotLanguage::Fanuc, RobotLanguage::Inform}) {
    far.layers[1].paths[0].points[1].x() = 99999.9994;
    EXPECT_EQ(refusalOf([&] { robotFiles(language, far); }), "") << toString(language);
    // 100000.000 once rounded.
    far.layers[1].paths[0].points[1].x() = -99999.9996;
    const std::string refusal = refusalOf([&] { robotFiles(language, far); });
    EXPECT_TRUE(holds(refusal, "the run from layer ")) << refusal;
    EXPECT_TRUE(holds(refusal, ": a coordinate is -100000 mm; must be within -99999.999 to 99999.999 mm in " +
                                   std::string(toString(language))))
        << refusal;
  }
}

TEST(RobotProgram, ProcessValuesNeedOutputsWithinTheirBounds) {
  const Toolpath toolpath = test::withValues(test::twoLayers(), 1);
  const auto refusal = [&](RobotLanguage language, const std::string& levels) {
    RobotProgramSettings settings;
    settings.levels = levels;
    return refusalOf([&] { robotFiles(language, toolpath, settings); });
  };
  EXPECT_TRUE(
      holds(refusal(RobotLanguage::Krl, ""), "layer 0, path 0: states the process value 'laser_power_w'"));
  const std::string strong = "laser_power_w=1*1, wire_speed_mm_s=2*0.01";
  EXPECT_TRUE(holds(refusal(RobotLanguage::Krl, strong), "KRL takes -1 to 1"));
  EXPECT_TRUE(holds(refusal(RobotLanguage::UrScript, "laser_power_w=1*1, wire_speed_mm_s=0*0.01"),
                    "URScript takes 0 to 1"));
  EXPECT_TRUE(holds(refusal(RobotLanguage::Krl, "laser_power_w=1*0.001, wire_speed_mm_s=0*0.01"),
                    "found output 0; expected 1 at least, from which KRL counts"));
  EXPECT_TRUE(holds(refusal(RobotLanguage::Inform, strong), "INFORM takes -14 to 14"));
  EXPECT_EQ(refusal(RobotLanguage::Fanuc, strong), "");
  EXPECT_TRUE(holds(refusal(RobotLanguage::UrScript, "laser_power_w=5*0.001, wire_speed_mm_s=0*0.01"),
                    "outputs 0 to 1; found 5"));
  for (const char* wrong : {"laser_power_w", "laser_power_w=1", "laser_power_w=x*1", "laser_power_w=1*0",
                            "laser_power_w=-1*1", "=1*1", "a=1*1, a=2*1", "a=1*1, b=1*2", "a=1*nan"})
    EXPECT_TRUE(holds(refusal(RobotLanguage::Krl, wrong), "robot_program.levels")) << wrong;
}

TEST(RobotProgram, LevelsAreZeroWhereTheProcessIsOff) {
  RobotProgramSettings settings;
  settings.levels = "laser_power_w=1*0.0025, wire_speed_mm_s=2*0.01";
  const std::string text =
      robotFiles(RobotLanguage::Krl, test::withValues(test::twoLayers(), 1), settings)[0].text;
  EXPECT_EQ(countIn(text, "$OUT[1]=FALSE\n$ANOUT[1]=0\n$ANOUT[2]=0\n"), 2U) << text;
  EXPECT_EQ(countIn(text, "TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]="), 3U) << text;
}

TEST(RobotProgram, RefusesDropsEventsAndSettingsThatCannotBe) {
  Toolpath drops = test::twoLayers();
  drops.layers[1].paths[0].deposit = Deposit::Drops;
  EXPECT_TRUE(holds(refusalOf([&] { robotFiles(RobotLanguage::Krl, drops); }), "drops are deposited"));
  Toolpath waits = test::twoLayers();
  waits.layers[1].paths[0].events = {{0, OperatorPause{"look"}}};
  EXPECT_TRUE(holds(refusalOf([&] { robotFiles(RobotLanguage::Krl, waits); }), "pause cannot be carried"));
  EXPECT_TRUE(holds(refusalOf([&] { robotFiles(RobotLanguage::Krl, {"empty", {}}); }), "no path"));
  RobotProgramSettings settings;
  settings.joint_signs = {1, 1, 2, 1, 1, 1};
  EXPECT_TRUE(holds(refusalOf([&] { requireConsistent(settings); }), "joint_signs holds 2"));
  settings = {};
  settings.date = "2000-13-01";
  EXPECT_TRUE(holds(refusalOf([&] { requireConsistent(settings); }), "robot_program.date is '2000-13-01'"));
  settings = {};
  settings.fanuc.turn_axes = {1.5};
  EXPECT_TRUE(holds(refusalOf([&] { requireConsistent(settings); }), "fanuc.turn_axes holds 1.5"));
  settings = {};
  settings.inform.pulses_per_deg = {1, 1, 1, 0, 1, 1};
  EXPECT_TRUE(holds(refusalOf([&] { requireConsistent(settings); }), "inform.pulses_per_deg holds 0"));
}

TEST(RobotProgram, IsTheSameEveryTime) {
  const Toolpath toolpath = test::tilted(test::randomToolpath(7), 7);
  for (const RobotLanguage language : kRobotLanguages)
    EXPECT_EQ(robotFiles(language, toolpath)[0].text, robotFiles(language, toolpath)[0].text);
}

}  // namespace
}  // namespace lamina
