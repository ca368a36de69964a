// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/robot/robot_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/rapid_programs.hpp"
#include "support/robot_programs.hpp"
#include "support/scratch_folder.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::robotFiles;

/// How far what is read back may be off, by the digits of a language.
struct RobotDigits {
  double position_mm = 0.0006;
  double turn_deg = 0.0002 * 1.7320508;
  double feed_mm_s = 0.0006;
  double feed_share = 0.0;
  double level_step = 1e-6;  // last decimal of an analogue output
};

RobotDigits digitsOf(RobotLanguage language) {
  RobotDigits digits;
  if (language == RobotLanguage::Fanuc) {
    digits.turn_deg = 0.001 * 1.7320508;
    digits.feed_share = 0.02;  // whole numbers
    digits.level_step = 1e-3;
  }
  if (language == RobotLanguage::Inform) {
    digits.feed_mm_s = 0.051;  // one decimal
    digits.level_step = 1e-2;
  }
  return digits;
}

/// Outputs of both values that are within the bounds of every language.
constexpr double kLaserPer = 0.0025;
constexpr double kWirePer = 0.03;
const char* readLevels(RobotLanguage language) {
  return language == RobotLanguage::UrScript ? "laser_power_w=0*0.0025, wire_speed_mm_s=1*0.03"
                                             : "laser_power_w=1*0.0025, wire_speed_mm_s=2*0.03";
}

void expectSamePathOf(const Path& read, const Path& written, const RobotDigits& digits) {
  RC_ASSERT(read.role == written.role);
  RC_ASSERT(read.is_closed == written.is_closed);
  RC_ASSERT(read.process.is_retracted == written.process.is_retracted);
  RC_ASSERT(read.points.size() == written.points.size());
  RC_ASSERT(read.values.size() == written.values.size());
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    RC_ASSERT((read.points[i] - written.points[i]).cwiseAbs().maxCoeff() <=
              digits.position_mm + (i == 0 ? 1e-3 : 0.0));
    RC_ASSERT(read.orientation.at(i).angularDistance(written.orientation.at(i)) * 180.0 / M_PI <=
              digits.turn_deg);
    if (i == 0 && !written.is_closed) continue;  // not used
    RC_ASSERT(std::abs(read.feed_mm_s.at(i) - written.feed_mm_s.at(i)) <=
              digits.feed_mm_s + digits.feed_share * written.feed_mm_s.at(i));
    if (written.role == PathRole::Travel) continue;
    RC_ASSERT(read.bead.at(i) == written.bead.at(i));
    for (std::size_t k = 0; k < read.values.size(); ++k) {
      RC_ASSERT(read.values[k].name == written.values[k].name);
      const double value = written.values[k].value.at(i);
      const double per = read.values[k].name == "laser_power_w" ? kLaserPer : kWirePer;
      RC_ASSERT(std::abs(read.values[k].value.at(i) - value) <= 0.51 * digits.level_step / per);
    }
  }
}

void expectSameToolpath(const Toolpath& read, const Toolpath& written, const RobotDigits& digits) {
  validate(read);
  RC_ASSERT(read.layers.size() == written.layers.size());
  for (std::size_t l = 0; l < read.layers.size(); ++l) {
    RC_ASSERT(read.layers[l].z_mm == written.layers[l].z_mm);
    RC_ASSERT(read.layers[l].height_mm == written.layers[l].height_mm);
    RC_ASSERT(read.layers[l].paths.size() == written.layers[l].paths.size());
    for (std::size_t p = 0; p < read.layers[l].paths.size(); ++p)
      expectSamePathOf(read.layers[l].paths[p], written.layers[l].paths[p], digits);
  }
}

class RobotReader : public testing::TestWithParam<RobotLanguage> {
 protected:
  std::string text() const { return robotFiles(GetParam(), test::twoLayers())[0].text; }
  std::string file() const { return std::string("a") + suffixOf(GetParam()); }

  Toolpath read(const std::string& text) const { return readRobotProgram({{file(), text}}, "part"); }

  /// The error that reading the text with `from` replaced by `to` gives.
  std::string refusal(const std::string& from, const std::string& to) const {
    std::string changed = text();
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at == std::string::npos) return "";
    changed.replace(at, from.size(), to);
    try {
      read(changed);
    } catch (const InvalidProgram& error) {
      return error.what();
    }
    return "";
  }
};

TEST_P(RobotReader, ReadsBackWhatWasWritten) {
  const RobotLanguage language = GetParam();
  EXPECT_TRUE(rc::check([language](std::uint64_t seed) {
    const Toolpath toolpath = test::withValues(test::tilted(test::randomToolpath(seed), seed), seed);
    RobotProgramSettings settings;
    settings.levels = readLevels(language);
    settings.process_lead_s = seed % 2 == 0 ? 0.0 : 0.25;
    settings.process_end_s = seed % 3 == 0 ? 0.0 : 1.5;
    settings.process_output = 1 + static_cast<int>(seed % 7);
    settings.krl.points = seed % 2 == 0 ? KrlPoints::Inline : KrlPoints::Dat;
    settings.inform.speed_unit =
        seed % 2 == 0 ? InformSpeedUnit::MillimetresPerSecond : InformSpeedUnit::CentimetresPerMinute;
    expectSameToolpath(readRobotProgram(robotFiles(language, toolpath, settings), "part"), toolpath,
                       digitsOf(language));
  }));
}

TEST_P(RobotReader, JoinsTheFilesOfASplitProgram) {
  const RobotLanguage language = GetParam();
  EXPECT_TRUE(rc::check([language](std::uint64_t seed) {
    const Toolpath toolpath = test::withValues(test::tilted(test::randomToolpath(seed), seed), seed);
    RobotProgramSettings settings;
    settings.levels = readLevels(language);
    settings.may_cut = true;
    settings.krl.max_lines = settings.fanuc.max_lines = 100 + static_cast<int>(seed % 50);
    settings.urscript.max_points = settings.inform.max_points = 4 + static_cast<int>(seed % 30);
    expectSameToolpath(readRobotProgram(robotFiles(language, toolpath, settings), "part"), toolpath,
                       digitsOf(language));
  }));
}

TEST_P(RobotReader, FindsTheFilesThatAProgramRuns) {
  const test::ScratchFolder folder;
  RobotProgramSettings settings;
  settings.may_cut = true;
  settings.urscript.max_points = settings.inform.max_points = 4;
  settings.krl.max_lines = settings.fanuc.max_lines = 100;
  Toolpath toolpath = test::randomToolpath(3);
  const std::vector<RobotFile> files = robotFiles(GetParam(), toolpath, settings, "part");
  EXPECT_GT(files.size(), 1U);
  for (const RobotFile& file : files) writeFile(folder.file(file.name), file.text);
  const Toolpath read = readRobotProgramFile(folder.file(files.front().name));
  EXPECT_EQ(totals(read).waypoints, totals(toolpath).waypoints);
  EXPECT_EQ(read.part_name.size(), 4U);
  // As a controller saves them.
  const test::ScratchFolder saved;
  const auto capitals = [](std::string name) {
    for (char& c : name) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return name;
  };
  for (const RobotFile& file : files) writeFile(saved.file(capitals(file.name)), file.text);
  const Toolpath read_back = readRobotProgramFile(saved.file(capitals(files.front().name)));
  EXPECT_EQ(totals(read_back).waypoints, totals(toolpath).waypoints);
  // Another is missing.
  std::vector<RobotFile> incomplete(files.begin(), files.end() - 1);
  try {
    readRobotProgram(incomplete, "part");
    FAIL();
  } catch (const InvalidProgram& error) {
    EXPECT_NE(std::string(error.what()).find("the file '" + files.back().name + "' is not there"),
              std::string::npos)
        << error.what();
  }
}

TEST_P(RobotReader, KeepsInclinedLayers) {
  Toolpath toolpath = test::twoLayers();
  toolpath.part_from_layers = Eigen::AngleAxisd(0.5, Point3::UnitX());
  const Toolpath read = readRobotProgram(robotFiles(GetParam(), toolpath), "part");
  EXPECT_LT(read.part_from_layers.angularDistance(toolpath.part_from_layers), 1e-9);
}

TEST_P(RobotReader, RefusesMovesThatTheNotesDoNotFit) {
  EXPECT_NE(refusal("# layer 0.2 0.2", "nothing").find("# layer'"), std::string::npos);
  EXPECT_NE(refusal("outer_wall closed", "outer_hall closed")
                .find("found 'outer_hall'; expected the role of a path"),
            std::string::npos);
  EXPECT_NE(refusal("# bead 0.4 0.2 4", "# bead 0.4 0.2 3").find("expected one bead for each"),
            std::string::npos);
  EXPECT_NE(refusal("# bead 0.4 0.2 4", "# beat 0.4 0.2 4").find("found 'beat'; expected layer, path"),
            std::string::npos);
  EXPECT_NE(refusal("# path travel open 1", "# path infill open 1")
                .find("the process is off in a path that is infill"),
            std::string::npos);
  EXPECT_NE(refusal("# path travel open 1", "# path travel open 2").find("1 moves of that of line"),
            std::string::npos);
  EXPECT_NE(refusal("# process 1", "# process 2").find("found output 1; expected 2"), std::string::npos);
  EXPECT_NE(refusal("# process 1", "# resumed 3").find("resumed for 3 moves; expected 0"), std::string::npos);
}

TEST_P(RobotReader, NamesFileLineAndWhatWasFound) {
  const std::string unknown =
      refusal(GetParam() == RobotLanguage::UrScript ? "movel(p[" : "10.000", "surprise");
  EXPECT_EQ(unknown.rfind("'" + file() + "' line ", 0), 0U) << unknown;
  EXPECT_NE(unknown.find("found 'surprise"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("; expected "), std::string::npos) << unknown;
}

TEST_P(RobotReader, ReadsOrRefusesAnyMutatedText) {
  RobotProgramSettings settings;
  settings.levels = readLevels(GetParam());
  const Toolpath toolpath = test::withValues(test::tilted(test::twoLayers(), 1), 1);
  const std::string whole = robotFiles(GetParam(), toolpath, settings)[0].text;
  const std::string name = file();
  EXPECT_TRUE(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    std::string mutated = whole;
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
      const std::size_t at = random.below(mutated.size());
      const std::size_t from = random.below(mutated.size());
      const std::size_t length = 1 + random.below(40);
      switch (random.below(4)) {
        case 0:
          mutated[at] = static_cast<char>(random.below(256));
          break;
        case 1:
          mutated.erase(at, length);
          break;
        case 2:
          mutated.insert(at, mutated.substr(from, length));
          break;
        default:
          mutated.insert(at, 1, "0123456789;,[]{}=#+-\n:"[random.below(22)]);
      }
    }
    try {
      validate(readRobotProgram({{name, mutated}}, "part"));
    } catch (const InvalidProgram& error) {
      RC_ASSERT(std::string(error.what()).find('\'') != std::string::npos);
    }
  }));
}

INSTANTIATE_TEST_SUITE_P(Languages, RobotReader, testing::ValuesIn(kRobotLanguages),
                         [](const auto& language) {
                           return std::string(suffixOf(language.param)).substr(1);
                         });

TEST(RobotReaderOfKrl, RefusesStatementsAndPointsThatAreNotKnown) {
  const std::string text = robotFiles(RobotLanguage::Krl, test::twoLayers())[0].text;
  const auto refusal = [&](const std::string& from, const std::string& to) -> std::string {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    try {
      readRobotProgram({{"a.src", changed}}, "part");
    } catch (const InvalidProgram& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(
      refusal("$ADVANCE=5", "HALT").find("'a.src' line 9: found 'HALT'; expected a statement that is known"),
      std::string::npos);
  EXPECT_NE(refusal("$VEL.CP=0.03", "$VEL.CP=0").find("found '0'; expected a speed in m/s"),
            std::string::npos);
  EXPECT_NE(refusal("$VEL.CP=0.03\n", "").find("expected $VEL.CP="), std::string::npos);
  EXPECT_NE(refusal("LIN {X 10.000,Y 0.000,Z 0.200", "LIN XP4 ;")
                .find("found 'xp4'; expected a point of the data file"),
            std::string::npos);
  EXPECT_NE(refusal("LIN {X 10.000", "LIN {X 1e9").find("a coordinate within 100 m"), std::string::npos);
  EXPECT_NE(refusal("END\n", "").find("found the end of the line; expected END"), std::string::npos);
  EXPECT_NE(
      refusal("$ADVANCE=5", "PTP {A1 0,A2 0,A3 0,A4 0,A5 0,A6 0}").find("a move of the joints amid the part"),
      std::string::npos);
}

TEST(RobotReaderOfFanuc, RefusesMovesWithoutTheirPoint) {
  std::string text = robotFiles(RobotLanguage::Fanuc, test::twoLayers())[0].text;
  text.replace(text.find("P[3]{"), 5, "P[9]{");
  try {
    readRobotProgram({{"a.ls", text}}, "part");
    FAIL();
  } catch (const InvalidProgram& error) {
    EXPECT_NE(std::string(error.what()).find("found 'P[3]'; expected a point below /POS"), std::string::npos)
        << error.what();
  }
}

TEST(RobotReaderOfInform, RefusesCountsThatAreNotTrueAndPointsUsedTwice) {
  const std::string text = robotFiles(RobotLanguage::Inform, test::twoLayers())[0].text;
  const auto refusal = [&](const std::string& from, const std::string& to) -> std::string {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    try {
      readRobotProgram({{"a.jbi", changed}}, "part");
    } catch (const InvalidProgram& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("///NPOS 7", "///NPOS 8").find("found '7 points'; expected 8, as ///NPOS says"),
            std::string::npos);
  EXPECT_NE(refusal("MOVL C00003", "MOVL C00002").find("found 'C00002'; expected each point in one move"),
            std::string::npos);
}

/// A job that goes to the part by its joints, and lays a bead of 10 mm.
std::string jobBy(const std::string& type, const std::string& approach, const std::string& note) {
  return "/JOB\n//NAME A\n//POS\n///NPOS 3,0,0,0,0,0\n///USER 1\n///TOOL 1\n" + type + "C00000=" + approach +
         "\n///USER 1\n///POSTYPE USER\n///RECTAN\n///RCONF 0,0,0,0,0,0,0,0\n"
         "C00001=0,0,0.2,180,0,0\nC00002=10,0,0.2,180,0,0\n//INST\n///ATTR SC,RW,RJ\n///GROUP1 RB1\nNOP\n"
         "'# process 1\n'# approach\n" +
         note +
         "MOVJ C00000 VJ=10.00\n'# layer 0.2 0.2\n'# path infill open turned 2\n'# bead 0.4 0.2 1\n"
         "MOVL C00001 V=30.0 PL=0\nDOUT OT#(1) ON\nMOVL C00002 V=30.0 PL=0\nDOUT OT#(1) OFF\nEND\n";
}

TEST(RobotReaderOfInform, TakesThePoseOfTheApproachWithANoteOfItsJointsAndJointsAsBefore) {
  const std::string pose = "///POSTYPE USER\n///RECTAN\n";
  const std::string at = "0,0,50.2,180,0,0";
  const std::string note = "'# stands 10.0000 -20.0000\n'#+ 30.0000 -40.0000 50.0000\n'#+ -60.0000\n";
  for (const std::string& job :
       {jobBy(pose, at, note), jobBy("///POSTYPE ANGLE\n///ANGLE\n", "10,-20,30,-40,50,-60", "")}) {
    const Toolpath read = readRobotProgram({{"a.jbi", job}}, "part");
    ASSERT_EQ(read.layers.size(), 1U);
    EXPECT_EQ(totals(read).waypoints, 2U);
  }
  try {
    readRobotProgram({{"a.jbi", jobBy(pose, at, "")}}, "part");
    ADD_FAILURE() << "read without the joints";
  } catch (const InvalidProgram& error) {
    EXPECT_NE(std::string(error.what()).find("expected a note of these joints before it"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace lamina
