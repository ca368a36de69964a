// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "lamina/program/five_axis/five_axis_reader.hpp"
#include "lamina/program/five_axis/five_axis_writer.hpp"
#include "support/random_toolpath.hpp"
#include "support/table_machine.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

const test::TableMachine kTable;

FiveAxisSettings settingsOf(FiveAxisCoordinates coordinates) {
  FiveAxisSettings settings;
  settings.coordinates = coordinates;
  return settings;
}

std::string fiveAxisWritten(const Toolpath& toolpath, const JointPath& joints,
                            const FiveAxisSettings& settings) {
  std::string text;
  writeFiveAxis({toolpath, Eigen::Isometry3d::Identity(), kTable, joints}, settings, {},
                [&text](std::string_view piece) { text += piece; });
  return text;
}

std::string fiveAxisWritten(const Toolpath& toolpath, const FiveAxisSettings& settings) {
  return fiveAxisWritten(toolpath, test::jointsAlong(toolpath, kTable), settings);
}

Toolpath readBack(const std::string& text) { return readFiveAxis(text, kTable, {}, {}, "part"); }

/// The toolpath with a nozzle that leans by some degrees, another way at each waypoint.
Toolpath leaning(Toolpath toolpath, std::uint64_t seed) {
  Random random(seed);
  Eigen::Quaterniond last = Eigen::AngleAxisd(0.3, Point3::UnitX()) * nozzleDown();
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      std::vector<Eigen::Quaterniond> each;
      for (std::size_t i = 0; i < path.points.size(); ++i)
        each.push_back(Eigen::AngleAxisd(random.uniform(0.2, 0.6), Point3::UnitX()) *
                       Eigen::AngleAxisd(random.uniform(-0.1, 0.1), Point3::UnitY()) * nozzleDown());
      if (random.below(3) != 0) each.front() = last;
      last = path.is_closed ? each.front() : each.back();
      path.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
    }
  return toolpath;
}

double toolAxisAngle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Point3 tool_axis = a * Point3::UnitZ();
  const Point3 other = b * Point3::UnitZ();
  return std::atan2(tool_axis.cross(other).norm(), tool_axis.dot(other));
}

/// @param position_mm  what rounding of the words leaves of a position
void expectSame(const Toolpath& read, const Toolpath& toolpath, double position_mm) {
  validate(read);
  RC_ASSERT(read.layers.size() == toolpath.layers.size());
  for (std::size_t l = 0; l < read.layers.size(); ++l) {
    const auto& paths = toolpath.layers[l].paths;
    RC_ASSERT(read.layers[l].paths.size() == paths.size());
    for (std::size_t p = 0; p < paths.size(); ++p) {
      const Path& path = read.layers[l].paths[p];
      RC_ASSERT(path.role == paths[p].role);
      RC_ASSERT(path.is_closed == paths[p].is_closed);
      RC_ASSERT(path.points.size() == paths[p].points.size());
      RC_ASSERT(std::abs(depositedVolume(path) - depositedVolume(paths[p])) < 1e-3);
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        RC_ASSERT((path.points[i] - paths[p].points[i]).norm() < position_mm);
        RC_ASSERT(toolAxisAngle(path.orientation.at(i), paths[p].orientation.at(i)) < 1e-6);
      }
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const std::size_t end = path.motionEnd(m);
        const double feed = paths[p].feed_mm_s.at(end);
        RC_ASSERT(std::abs(path.feed_mm_s.at(end) - feed) < 0.01 * feed);
      }
    }
  }
}

TEST(FiveAxis, ReadsBackTipCoordinatesWithinTheirDecimals) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Toolpath toolpath = leaning(test::randomToolpath(seed), seed);
    expectSame(readBack(fiveAxisWritten(toolpath, settingsOf(FiveAxisCoordinates::ToolTip))), toolpath, 1e-4);
  }));
}

TEST(FiveAxis, ReadsBackJointsThroughForwardKinematics) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Toolpath toolpath = leaning(test::randomToolpath(seed), seed);
    expectSame(readBack(fiveAxisWritten(toolpath, settingsOf(FiveAxisCoordinates::Joints))), toolpath, 3e-4);
  }));
}

/// A line of 10 mm that the table turns under by 30 deg, and on.
Toolpath turningLine() {
  Path line = test::straightPath({20, 0, 0.2}, {30, 0, 0.2});
  const auto lean = [](double c) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(-c, Point3::UnitZ()) *
                              Eigen::AngleAxisd(-0.3, Point3::UnitX())) *
           nozzleDown();
  };
  line.orientation =
      AlongPath<Eigen::Quaterniond>(std::vector<Eigen::Quaterniond>{lean(0.0), lean(M_PI / 6.0)});
  return {"line", {{0.2, 0.2, {line}}}};
}

TEST(FiveAxis, WritesTipCoordinatesBetweenTheCodesOfTheDialect) {
  FiveAxisSettings settings = settingsOf(FiveAxisCoordinates::ToolTip);
  settings.dialect = FiveAxisDialect::Siemens;
  const std::string text = fiveAxisWritten(turningLine(), settings);
  EXPECT_NE(text.find(";FIVE_AXIS:tool_tip X Y Z A C\n"), std::string::npos);
  EXPECT_NE(text.find("; start of the part\nG0 A17.18873 C0\nTRAORI\nG0 X20 Y0\nG0 Z0.2\nG94\n"),
            std::string::npos)
      << text;
  // The lift: 10 mm along (sin 0.3 sin 30°, sin 0.3 cos 30°, cos 0.3). 10 mm of a bead of 0.4 x 0.2 mm: (0.04
  // + pi 0.01) mm² of a filament of pi 0.875² mm².
  EXPECT_NE(text.find("\nG1 X30 C30 U0.29691 F1800\n; end of the part\n"
                      "G0 X31.4776 Y2.5593 Z9.7534 ;retract\nTRAFOOF\n"),
            std::string::npos)
      << text;
}

TEST(FiveAxis, NamesRotaryJointsAsTheMachineDoes) {
  FiveAxisSettings settings = settingsOf(FiveAxisCoordinates::ToolTip);
  settings.letters = "a=U, c=V";
  const std::string text = fiveAxisWritten(turningLine(), settings);
  EXPECT_NE(text.find(";FIVE_AXIS:tool_tip X Y Z U V\n"), std::string::npos);
  EXPECT_NE(text.find("\nG1 X30 V30 E0.29691 F1800\n"), std::string::npos) << text;
  const Toolpath read = readFiveAxis(text, kTable, settings, {}, "part");
  EXPECT_NEAR(toolAxisAngle(read.layers[0].paths[0].orientation.at(1),
                            turningLine().layers[0].paths[0].orientation.at(1)),
              0.0, 1e-6);
  EXPECT_THROW(readBack(text), InvalidProgram) << "by the letters of the joints";
  for (const char* bad : {"a=X", "x=U", "b=U", "a=U,c=U", "a=C", "a", "a=UV", "a:U"}) {
    settings.letters = bad;
    EXPECT_THROW(fiveAxisWritten(turningLine(), settings), InvalidConfig) << bad;
  }
}

TEST(FiveAxis, WritesJointsWithInverseTimeThatSumsUpToTheTimeOfTheToolpath) {
  const std::string text = fiveAxisWritten(turningLine(), settingsOf(FiveAxisCoordinates::Joints));
  double minutes = 0.0;
  std::size_t lines = 0;
  for (std::size_t at = text.find("\nG1 "); at != std::string::npos; at = text.find("\nG1 ", at + 1), ++lines)
    minutes += 1.0 / std::stod(text.substr(text.find(" F", at) + 2));
  EXPECT_NEAR(60.0 * minutes, 10.0 / 30.0, 1e-4);
  EXPECT_GT(lines, 2U) << "the tip leaves its line by 0.8 mm halfway";
  EXPECT_EQ(text.find("G93") < text.find("G1 "), true);
  EXPECT_NE(text.find("; end of the part\nG94\n"), std::string::npos);
  EXPECT_EQ(readBack(text).layers[0].paths[0].points.size(), 2U);
}

TEST(FiveAxis, ReadsBackTheInverseTimeOfTheShortestMotionThatIsWritten) {
  Toolpath toolpath = turningLine();
  Path hop = test::straightPath({30, 0, 0.2}, {30.001, 0, 0.2});
  hop.role = PathRole::Travel;
  hop.bead = Bead{};
  hop.orientation = toolpath.layers[0].paths[0].orientation.at(1);
  hop.feed_mm_s = 500.0;
  toolpath.layers[0].paths.push_back(hop);
  const std::string text = fiveAxisWritten(toolpath, settingsOf(FiveAxisCoordinates::Joints));
  const std::size_t feed = text.rfind(" F", text.find("; end of the part")) + 2;
  EXPECT_NEAR(std::stod(text.substr(feed)), 3e7, 1.0) << "60 s/min over 2 us";
  EXPECT_EQ(readBack(text).layers[0].paths.size(), 2U);
}

/// A line of 10 mm and a travel on from it, at whose beginning the nozzle is leant from 0.3 to 1.1 rad in
/// eight steps.
Toolpath turningInPlace() {
  const auto lean = [](double rad) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(-rad, Point3::UnitX())) * nozzleDown();
  };
  Path line = test::straightPath({20, 0, 0.2}, {30, 0, 0.2});
  line.orientation = lean(0.3);
  Path travel = test::straightPath({30, 0, 0.2}, {40, 0, 10});
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  travel.points.insert(travel.points.begin(), 8, Point3(30, 0, 0.2));
  std::vector<Eigen::Quaterniond> each;
  each.reserve(travel.points.size());
  for (std::size_t w = 0; w < travel.points.size(); ++w)
    each.push_back(lean(0.3 + 0.1 * static_cast<double>(std::min<std::size_t>(w, 8))));
  travel.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
  return {"turn", {{0.2, 0.2, {line, travel}}}};
}

TEST(FiveAxis, StatesTheJointsOfEachLineOfATurnInPlace) {
  for (const auto coordinates : {FiveAxisCoordinates::ToolTip, FiveAxisCoordinates::Joints}) {
    const std::string text = fiveAxisWritten(turningInPlace(), settingsOf(coordinates));
    const StatedMotion stated = readFiveAxisMotion(text, kTable, {}, {}, "turn");
    validate(stated.toolpath);
    const std::vector<Path>& paths = stated.toolpath.layers.at(0).paths;
    ASSERT_EQ(paths.size(), 3U);
    EXPECT_EQ(paths[1].role, PathRole::Travel);
    ASSERT_EQ(paths[1].points.size(), 9U) << "before the turn, and after each of its lines";
    for (std::size_t w = 0; w < 9; ++w) {
      EXPECT_LT((paths[1].points[w] - Point3(30, 0, 0.2)).norm(), 1e-3);
      const std::size_t i = w + 2;
      const WaypointIndex expected{0, 1, w};
      EXPECT_TRUE(stated.joints.at.at(i) == expected);
      EXPECT_NEAR(std::abs(stated.joints.values.at(i)[3]), 0.3 + 0.1 * static_cast<double>(w), 1e-6);
      EXPECT_LT((kTable.bedFromNozzle(stated.joints.values[i]).translation() - paths[1].points[w]).norm(),
                1e-3);
      if (w > 0) {
        EXPECT_EQ(stated.lines.at(i), stated.lines.at(i - 1) + 1);
      }
    }
    EXPECT_EQ(stated.joints.at.back().path, 2U);
    EXPECT_EQ(stated.joints.at.size(), stated.lines.size());
  }
}

TEST(FiveAxis, RefusesJointsThatCannotBeRunBeforeTheFirstPiece) {
  const Toolpath toolpath = turningLine();
  const JointPath joints = test::jointsAlong(toolpath, kTable);
  const auto refusal = [&toolpath](const JointPath& given) -> std::string {
    try {
      writeFiveAxis({toolpath, Eigen::Isometry3d::Identity(), kTable, given}, {}, {},
                    [](std::string_view) { FAIL(); });
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  JointPath faulty = joints;
  faulty.faults.push_back({{0, 0, 1}, JointFault::JointUnwinding, "joint c is wound up"});
  JointPath outside = joints;
  outside.values[1][0] = 501.0;
  JointPath elsewhere = joints;
  elsewhere.values[1][0] += 1.0;
  JointPath less = joints;
  less.at.pop_back();
  less.values.pop_back();
  EXPECT_EQ(refusal(faulty),
            "'table' cannot run 1 waypoint(s); the first is layer 0, path 0, waypoint 1: joint_unwinding, "
            "joint c is "
            "wound up");
  EXPECT_NE(refusal(outside).find("waypoint 1, 'table': joint x at 501.000000 mm; must be within"),
            std::string::npos);
  EXPECT_NE(refusal(elsewhere).find("waypoint 1: the joints bring the nozzle 1 mm"), std::string::npos);
  EXPECT_NE(refusal(less).find("ends before layer 0, path 0, waypoint 1"), std::string::npos);
}

std::string readRefusal(const std::string& from, const std::string& to) {
  std::string text = fiveAxisWritten(turningLine(), settingsOf(FiveAxisCoordinates::Joints));
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    readBack(text);
  } catch (const InvalidProgram& error) {
    return error.what();
  }
  return "";
}

TEST(FiveAxis, ReaderNamesTheLineWhatWasFoundAndWhatWasExpected) {
  EXPECT_NE(readRefusal("X Y Z A C", "X Y Z B C").find("expected those of 'table', X Y Z A C"),
            std::string::npos);
  EXPECT_NE(readRefusal("G93", "G95").find("found 'G95'; expected G0, G1, G93, G94"), std::string::npos);
  EXPECT_NE(
      readRefusal("\nG1 X", "\nG1 B").find("found the word B; expected G, E, F or an axis of X Y Z A C"),
      std::string::npos);
  EXPECT_NE(readRefusal("\nG1 ", "\nG2 ").find("expected G0 or G1"), std::string::npos);
  EXPECT_NE(readRefusal("G0 A17.18873 C0", "G0 A17.18873").find("a motion before any position"),
            std::string::npos);
  EXPECT_NE(readRefusal("; end of the part", "").find("expected G0 or G1"), std::string::npos);
}

TEST(FiveAxis, ReadsOrRefusesAnyMutatedText) {
  const std::string text =
      fiveAxisWritten(leaning(test::twoLayers(), 1), settingsOf(FiveAxisCoordinates::ToolTip));
  EXPECT_TRUE(rc::check([&text](std::uint64_t seed) {
    Random random(seed);
    std::string mutated = text;
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
      const std::size_t at = random.below(mutated.size());
      const std::size_t from = random.below(mutated.size());
      if (random.below(2) == 0)
        mutated.erase(at, 1 + random.below(30));
      else
        mutated.insert(at, mutated.substr(from, 1 + random.below(30)));
    }
    try {
      validate(readBack(mutated));
    } catch (const InvalidProgram&) {
    }
  }));
}

}  // namespace
}  // namespace lamina
