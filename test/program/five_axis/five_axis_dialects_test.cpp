// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Programs of named dialects before readers that take no more than the controllers' manuals say they take.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <variant>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "lamina/program/five_axis/five_axis_reader.hpp"
#include "lamina/program/five_axis/five_axis_writer.hpp"
#include "program/five_axis/fanuc_text.hpp"
#include "support/table_machine.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

const test::TableMachine kDialectTable;

/// A line of 40 mm that the table turns under by 80 deg, a fan, a wait, and a hop back.
Toolpath turnedLine() {
  Path line = test::straightPath({20, 0, 0.2}, {60, 0, 0.2});
  const auto lean = [](double c) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(-c, Point3::UnitZ()) *
                              Eigen::AngleAxisd(-0.3, Point3::UnitX())) *
           nozzleDown();
  };
  line.orientation = AlongPath<Eigen::Quaterniond>(std::vector<Eigen::Quaterniond>{lean(0.0), lean(1.4)});
  line.events = {{0, FanShare{0.5}}, {1, Dwell{0.25}}};
  Path hop = test::straightPath({60, 0, 0.2}, {60.001, 0, 0.2});
  hop.role = PathRole::Travel;
  hop.bead = Bead{};
  hop.feed_mm_s = 500.0;
  hop.orientation = lean(1.4);
  hop.process.is_retracted = true;
  return {"line", {{0.2, 0.2, {line, hop}}}};
}

ProgramSettings programIn(FiveAxisDialect dialect, FiveAxisCoordinates coordinates) {
  ProgramSettings program;
  program.start_code.clear();
  program.end_code.clear();
  program.five_axis.dialect = dialect;
  program.five_axis.coordinates = coordinates;
  return program;
}

std::string writtenIn(const ProgramSettings& program) {
  const Toolpath toolpath = turnedLine();
  std::string text;
  writeFiveAxis(
      {toolpath, Eigen::Isometry3d::Identity(), kDialectTable, test::jointsAlong(toolpath, kDialectTable)},
      program.five_axis, program, [&text](std::string_view piece) { text += piece; });
  return text;
}

/// The words of a line without its comment, each letter once.
std::multimap<char, std::string> wordsOf(std::string line) {
  line = line.substr(0, line.find_first_of(";("));
  std::multimap<char, std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.emplace(word[0], word.substr(1));
  return words;
}

/// What holds of both: known codes alone, every letter once but G, F in each motion of inverse time.
class StrictReader {
 public:
  StrictReader(std::set<std::string> codes, std::string letters)
      : codes_(std::move(codes)), letters_(std::move(letters)) {}

  void read(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      ASSERT_FALSE(has_ended_) << "after the end: " << line;
      readLine(line);
    }
    EXPECT_TRUE(has_ended_) << "no M2 or M30";
  }

  double least_inverse = 1e300;
  double most_inverse = 0.0;
  std::vector<std::string> seen;

 private:
  void readLine(const std::string& line) {
    const auto words = wordsOf(line);
    bool moves = false;
    for (const auto& [letter, value] : words) {
      EXPECT_TRUE(letter == 'G' || words.count(letter) == 1U) << line;
      if (letter == 'G' || letter == 'M') {
        EXPECT_EQ(codes_.count(letter + value), 1U) << line;
        seen.push_back(letter + value);
        if (value == "93" && letter == 'G') is_inverse_ = true;
        if (value == "94" && letter == 'G') is_inverse_ = false;
        moves |= letter == 'G' && value == "1";
        has_ended_ |= letter + value == "M2" || letter + value == "M30";
      } else {
        EXPECT_NE(letters_.find(letter), std::string::npos) << line;
        EXPECT_NO_THROW(std::stod(value)) << line;
      }
    }
    if (!moves || !is_inverse_) return;
    ASSERT_EQ(words.count('F'), 1U) << "inverse time without F: " << line;
    least_inverse = std::min(least_inverse, std::stod(words.find('F')->second));
    most_inverse = std::max(most_inverse, std::stod(words.find('F')->second));
  }

  std::set<std::string> codes_;
  std::string letters_;
  bool is_inverse_ = false;
  bool has_ended_ = false;
};

TEST(FiveAxisDialects, LinuxCncTakesEveryWord) {
  for (const auto coordinates : {FiveAxisCoordinates::ToolTip, FiveAxisCoordinates::Joints}) {
    const ProgramSettings program = programIn(FiveAxisDialect::LinuxCnc, coordinates);
    const std::string text = writtenIn(program);
    // E belongs to M67 alone, Q too.
    StrictReader reader(
        {"G0", "G1", "G4", "G21", "G90", "G92", "G92.1", "G93", "G94", "M2", "M67", "M428", "M429"},
        "XYZACUFPEQ");
    reader.read(text);
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
      EXPECT_TRUE(wordsOf(line).count('E') == 0 || line.find("M67 E0 Q") == 0) << line;
    EXPECT_NE(text.find("\nG4 P0.25\n"), std::string::npos) << "waits are in seconds";
    const bool has_tip = coordinates == FiveAxisCoordinates::ToolTip;
    // The machine may start with tool-tip coordinates on: off for the rotary axes, then on.
    EXPECT_LT(text.find("M429\nG0 A"), text.find("\nG0 X"));
    EXPECT_EQ(text.find("\nM428\n") != std::string::npos, has_tip);
  }
}

TEST(FiveAxisDialects, LinuxCncFeedsByAnAxisThatIsReadBack) {
  ProgramSettings program = programIn(FiveAxisDialect::LinuxCnc, FiveAxisCoordinates::ToolTip);
  const Toolpath read = readFiveAxis(writtenIn(program), kDialectTable, program.five_axis, program, "part");
  EXPECT_NEAR(depositedVolume(read.layers[0].paths[0]), depositedVolume(turnedLine().layers[0].paths[0]),
              1e-3);
  ASSERT_EQ(read.layers[0].paths.size(), 2U);
  EXPECT_TRUE(read.layers[0].paths[1].process.is_retracted);
  for (const char* letter : {"A", "E", "X", "UV"}) {
    program.five_axis.extrusion = letter;
    EXPECT_THROW(writtenIn(program), InvalidConfig) << letter;
  }
}

TEST(FiveAxisDialects, FanucTakesEveryInverseTime) {
  const std::string text = writtenIn(programIn(FiveAxisDialect::Fanuc, FiveAxisCoordinates::Joints));
  // Between the marks, behind the program's number.
  const std::string begin = "%\nO0001 (LINE)\n";
  const std::string end = "M30\n%\n";
  ASSERT_EQ(text.substr(0, begin.size()), begin);
  ASSERT_EQ(text.substr(text.size() - end.size()), end);
  StrictReader reader({"G0", "G1", "G4", "G21", "G90", "G92", "G93", "G94", "M30"}, "XYZACUFP");
  reader.read(text.substr(begin.size(), text.size() - begin.size() - 2));
  EXPECT_GE(reader.least_inverse, 0.001);
  EXPECT_LE(reader.most_inverse, 9999.999);
  EXPECT_NE(text.find("F9999.999\n"), std::string::npos) << "the hop takes 2 us";
  EXPECT_NE(text.find("\nG4 P250\n"), std::string::npos) << "waits are in milliseconds";
}

/// A straight line whose nozzle leans by 0.3 rad, towards the tilt of the table alone.
Toolpath leaningLine() {
  Path line = test::straightPath({20, 0, 0.2}, {60, 0, 0.2});
  line.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(-0.3, Point3::UnitX())) * nozzleDown();
  return {"line (1)", {{0.2, 0.2, {line}}}};
}

std::string leaningLineIn(const ProgramSettings& program) {
  const Toolpath toolpath = leaningLine();
  std::string text;
  writeFiveAxis(
      {toolpath, Eigen::Isometry3d::Identity(), kDialectTable, test::jointsAlong(toolpath, kDialectTable)},
      program.five_axis, program, [&text](std::string_view piece) { text += piece; });
  return text;
}

// By hand. The lift of 10 mm along the tool axis is (0, sin 0.3, cos 0.3) of it. Material: a bead of 0.4 x
// 0.2 mm is (0.2 * 0.2 + pi 0.1 * 0.1) mm2, 40 mm of it 2.856637 mm3, of filament of 1.75 mm 1.18765 mm. A
// word without a point would be counted in thousandths.
constexpr char kFanucListing[] =
    "%\n"
    "O0042 (LINE -1-)\n"
    "(GENERATED BY LAMINA)\n"
    "(LAYER_COUNT:1)\n"
    "(FIVE_AXIS:TOOL_TIP X Y Z A C)\n"
    "G21\n"
    "G90\n"
    "G92 U0.\n"
    "(START OF THE PART)\n"
    "G0 A17.18873 C0.\n"
    "G43.4 H1\n"
    "G0 X20. Y0.\n"
    "G0 Z0.2\n"
    "G94\n"
    "(LAYER:0)\n"
    "(Z:0.2)\n"
    "(HEIGHT:0.2)\n"
    "(TYPE:INFILL)\n"
    "(HEIGHT:0.2)\n"
    "G1 X60. U1.18765 F1800.\n"
    "(END OF THE PART)\n"
    "G0 Y2.9552 Z9.7534 (RETRACT)\n"
    "G91 G28 Z0.\n"
    "G49\n"
    "G90\n"
    "M30\n"
    "%\n";

TEST(FiveAxisDialects, FanucListingIsThatOfTheManual) {
  ProgramSettings program = programIn(FiveAxisDialect::Fanuc, FiveAxisCoordinates::ToolTip);
  program.five_axis.program_number = 42;
  const std::string text = leaningLineIn(program);
  EXPECT_EQ(text, kFanucListing);
  ASSERT_TRUE(isFiveAxisProgram(text));
  const Toolpath read = readFiveAxis(text, kDialectTable, program.five_axis, program, "part");
  const Path& path = read.layers.at(0).paths.at(0);
  EXPECT_EQ(path.role, PathRole::Infill);
  EXPECT_TRUE(path.points.back().isApprox(Point3(60, 0, 0.2), 1e-9));
  EXPECT_NEAR(path.feed_mm_s.at(1), 30.0, 1e-9);
  EXPECT_LT(path.orientation.at(1).angularDistance(leaningLine().layers[0].paths[0].orientation.at(0)), 1e-6);
  EXPECT_NEAR(depositedVolume(path), 2.856637, 1e-4);
}

TEST(FiveAxisDialects, FanucProgramsAreReadBackWithTurnsAndClosedPaths) {
  for (const auto coordinates : {FiveAxisCoordinates::ToolTip, FiveAxisCoordinates::Joints}) {
    const ProgramSettings fanuc = programIn(FiveAxisDialect::Fanuc, coordinates);
    const Toolpath read = readFiveAxis(writtenIn(fanuc), kDialectTable, fanuc.five_axis, fanuc, "part");
    ASSERT_EQ(read.layers.size(), 1U);
    ASSERT_EQ(read.layers[0].paths.size(), 2U);
    const Path& line = read.layers[0].paths[0];
    ASSERT_EQ(line.points.size(), 2U) << "lines in between are no waypoints";
    EXPECT_TRUE(line.points.back().isApprox(Point3(60, 0, 0.2), 1e-4));
    // A wait behind the line is one before the hop; the fan is a comment.
    const auto& events = read.layers[0].paths[1].events;
    ASSERT_EQ(line.events.size() + events.size(), 1U);
    EXPECT_EQ(std::get<Dwell>(events.at(0).event).duration_s, 0.25);
    EXPECT_TRUE(read.layers[0].paths[1].process.is_retracted);
  }
}

// More digits than eight in a word are alarm 003; material and turns of a table add up to such.
TEST(FiveAxisDialects, FanucWordsHaveEightDigitsAtMost) {
  EXPECT_EQ(fanucText("G1 X-18.6093 C-140.41564 U1418.49524 F1200\nG1 C-1852.58109 U99999.99951 ;via\n"),
            "G1 X-18.6093 C-140.41564 U1418.4952 F1200.\nG1 C-1852.5811 U100000. (VIA)\n");
  EXPECT_EQ(fanucText("G1 C-185241.58102\n"), "G1 C-185241.58\n");
}

/// A table that turns without end.
class EndlessTable : public test::TableMachine {
 public:
  EndlessTable() : endless_(test::TableMachine::joints()) {
    endless_[4].low = -std::numeric_limits<double>::infinity();
    endless_[4].high = std::numeric_limits<double>::infinity();
  }
  const std::vector<DrivenJoint>& joints() const override { return endless_; }

 private:
  std::vector<DrivenJoint> endless_;
};

const EndlessTable kEndlessTable;

/// A line under which the table turns by 100 deg from waypoint to waypoint, 700 deg in all.
Toolpath woundLine() {
  Path line = test::straightPath({20, 0, 0.2}, {27, 0, 0.2});
  line.points.clear();
  std::vector<Eigen::Quaterniond> each;
  for (int k = 0; k < 8; ++k) {
    line.points.emplace_back(20.0 + k, 0.0, 0.2);
    each.push_back(Eigen::AngleAxisd(-k * 100.0 / 180.0 * M_PI, Point3::UnitZ()) *
                   Eigen::AngleAxisd(-0.3, Point3::UnitX()) * nozzleDown());
  }
  line.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
  return {"line", {{0.2, 0.2, {line}}}};
}

/// @param turns  whole turns added to the table's at all waypoints from `from` on
std::string woundText(const ProgramSettings& program, int turns = 0, std::size_t from = 0) {
  const Toolpath toolpath = woundLine();
  JointPath joints = test::jointsAlong(toolpath, kEndlessTable);
  for (std::size_t i = from; i < joints.values.size(); ++i) joints.values[i][4] += turns * 2.0 * M_PI;
  std::string text;
  writeFiveAxis({toolpath, Eigen::Isometry3d::Identity(), kEndlessTable, joints}, program.five_axis, program,
                [&text](std::string_view piece) { text += piece; });
  return text;
}

std::string refusedTurns(const ProgramSettings& program, int turns, std::size_t from) {
  try {
    woundText(program, turns, from);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(FiveAxisDialects, TurnsWithinOneTurnAreReadBackAsTheyWind) {
  for (const auto dialect : {FiveAxisDialect::Fanuc, FiveAxisDialect::Siemens})
    for (const auto coordinates : {FiveAxisCoordinates::ToolTip, FiveAxisCoordinates::Joints}) {
      ProgramSettings program = programIn(dialect, coordinates);
      program.five_axis.turns = FiveAxisTurns::Modulo;
      const std::string text = woundText(program);
      const bool is_fanuc = dialect == FiveAxisDialect::Fanuc;
      for (const char* angle : {"0", "100", "200", "300", "40", "140", "240", "340"}) {
        const std::string word =
            is_fanuc ? std::string(" C") + angle + "." : std::string(" C=DC(") + angle + ")";
        EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
      }
      const StatedMotion read = readFiveAxisMotion(text, kEndlessTable, program.five_axis, program, "part");
      EXPECT_NEAR(read.joints.values.back()[4], 700.0 / 180.0 * M_PI, 1e-6);
      program.five_axis.turns = FiveAxisTurns::Counted;
      EXPECT_NE(woundText(program).find(is_fanuc ? " C700." : " C700"), std::string::npos);
    }
}

TEST(FiveAxisDialects, FanucTakesNoTurnsBeyondItsNumbers) {
  ProgramSettings program = programIn(FiveAxisDialect::Fanuc, FiveAxisCoordinates::ToolTip);
  EXPECT_EQ(refusedTurns(program, 275, 0), "");  // 99 000 to 99 700 deg
  EXPECT_NE(
      refusedTurns(program, -278, 0).find("axis C is at -100080 deg; a Fanuc control takes 99 999.999 deg"),
      std::string::npos);
  program.five_axis.turns = FiveAxisTurns::Modulo;
  EXPECT_EQ(woundText(program, -278), woundText(program));
}

TEST(FiveAxisDialects, FanucTakesNoMaterialBeyondItsNumbers) {
  const auto refusal = [](FiveAxisDialect dialect) -> std::string {
    ProgramSettings program = programIn(dialect, FiveAxisCoordinates::ToolTip);
    program.filament_diameter_mm = 0.001;  // kilometres of it for a line of 40 mm
    try {
      writtenIn(program);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  const std::string fanuc = refusal(FiveAxisDialect::Fanuc);
  EXPECT_NE(fanuc.find("mm of material; a Fanuc control takes 99 999.999 mm at most"), std::string::npos)
      << fanuc;
  EXPECT_EQ(refusal(FiveAxisDialect::Siemens), "");
}

TEST(FiveAxisDialects, TurnsWithinOneTurnGoTheShorterWay) {
  ProgramSettings program = programIn(FiveAxisDialect::Siemens, FiveAxisCoordinates::ToolTip);
  program.five_axis.turns = FiveAxisTurns::Modulo;
  EXPECT_NE(refusedTurns(program, 1, 3).find("axis C turns by 460 deg in one line; must be less than 180"),
            std::string::npos);
  program.five_axis.dialect = FiveAxisDialect::LinuxCnc;
  EXPECT_THROW(woundText(program), InvalidConfig);
}

TEST(FiveAxisDialects, FanucProgramsHaveANumberOrAName) {
  ProgramSettings program = programIn(FiveAxisDialect::Fanuc, FiveAxisCoordinates::ToolTip);
  program.five_axis.program_number = 12345;
  EXPECT_EQ(leaningLineIn(program).find("%\nO00012345 ("), 0U);
  program.five_axis.program_name = "BLADE-2.NC";
  EXPECT_EQ(leaningLineIn(program).find("%\n<BLADE-2.NC> (LINE -1-)\n"), 0U);
  for (const char* name : {"blade", "A B", "A>", "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456"}) {
    program.five_axis.program_name = name;
    EXPECT_THROW(leaningLineIn(program), InvalidConfig) << name;
  }
}

/// The tip by hand: the table tilts about x and turns about z on that, and its words are in degrees.
Point3 tipAt(const std::map<char, double>& axes) {
  const double a = axes.at('A') * M_PI / 180.0;
  const double c = axes.at('C') * M_PI / 180.0;
  const Point3 place(axes.at('X'), axes.at('Y'), axes.at('Z'));
  const Point3 tilted_back(place.x(), std::cos(a) * place.y() + std::sin(a) * place.z(),
                           -std::sin(a) * place.y() + std::cos(a) * place.z());
  return {std::cos(c) * tilted_back.x() + std::sin(c) * tilted_back.y(),
          -std::sin(c) * tilted_back.x() + std::cos(c) * tilted_back.y(), tilted_back.z()};
}

TEST(FiveAxisDialects, TheTipKeepsToItsLineBetweenLinesOfJoints) {
  for (const double tolerance_mm : {0.05, 0.01, 0.002}) {
    ProgramSettings program = programIn(FiveAxisDialect::Generic, FiveAxisCoordinates::Joints);
    program.five_axis.chord_tolerance_mm = tolerance_mm;
    std::istringstream stream(writtenIn(program));
    std::map<char, double> axes;
    double farthest_mm = 0.0;
    for (std::string line; std::getline(stream, line);) {
      const std::map<char, double> before = axes;
      if (line.find("G0 ") != 0 && line.find("G1 ") != 0) continue;
      for (const auto& [letter, value] : wordsOf(line))
        if (std::string("XYZAC").find(letter) != std::string::npos) axes[letter] = std::stod(value);
      if (line.find("G1 ") != 0) continue;
      for (int i = 0; i <= 50; ++i) {
        std::map<char, double> between = axes;
        for (auto& [letter, value] : between)
          value = before.at(letter) + (value - before.at(letter)) * i / 50.0;
        const Point3 tip = tipAt(between);  // the line is y 0, z 0.2
        farthest_mm = std::max(farthest_mm, std::hypot(tip.y(), tip.z() - 0.2));
      }
    }
    EXPECT_LE(farthest_mm, tolerance_mm + 2e-4) << "decimals of the words";
    EXPECT_GT(farthest_mm, 0.1 * tolerance_mm);
  }
}

TEST(FiveAxisDialects, JointsThatSwingLessThanAskedAreWritten) {
  // A nozzle that leans by 1 deg to changing sides, which c follows unless it may stay.
  Path line = test::straightPath({0, 0, 0.2}, {10, 0, 0.2});
  line.points = {{0, 0, 0.2}, {2, 0, 0.2}, {4, 0, 0.2}, {6, 0, 0.2}, {8, 0, 0.2}};
  std::vector<Eigen::Quaterniond> each;
  for (const double side : {0.0, 0.6, 1.2, 0.5, 0.0})
    each.push_back(Eigen::AngleAxisd(0.0175, Point3(std::cos(side), std::sin(side), 0.0)) * nozzleDown());
  line.orientation = AlongPath<Eigen::Quaterniond>(each);
  const Toolpath toolpath{"line", {{0.2, 0.2, {line}}}};
  const auto machine = kinematicModelByName("five_axis_head_ac");
  JointPathSettings settings;
  settings.swing_tolerance_deg = 0.7;
  NoProgress nobody;
  const Eigen::Isometry3d bed_from_part(Eigen::Translation3d(100, 100, 0));
  const JointPath joints = planJointPath(toolpath, bed_from_part, *machine, settings, nobody);
  ASSERT_TRUE(joints.isRunnable());
  const ProgramSettings program = programIn(FiveAxisDialect::Generic, FiveAxisCoordinates::ToolTip);
  std::string text;
  writeFiveAxis({toolpath, bed_from_part, *machine, joints}, program.five_axis, program,
                [&text](std::string_view piece) { text += piece; });
  const Toolpath read = readFiveAxis(text, *machine, program.five_axis, program, "part");
  double greatest = 0.0;
  for (std::size_t i = 0; i < each.size(); ++i) {
    EXPECT_LT((read.layers[0].paths[0].points[i] - bed_from_part * line.points[i]).norm(), 1e-3);
    const Point3 axis = read.layers[0].paths[0].orientation.at(i) * Point3::UnitZ();
    const Point3 asked = each[i] * Point3::UnitZ();
    greatest = std::max(greatest, std::atan2(axis.cross(asked).norm(), axis.dot(asked)) * 180.0 / M_PI);
  }
  EXPECT_LE(greatest, 0.7 + 1e-4);
  EXPECT_GT(greatest, 0.1) << "it swings as it is asked to";
}

}  // namespace
}  // namespace lamina
